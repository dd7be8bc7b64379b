// SPDX-License-Identifier: GPL-3.0-or-later
// The script runs in the page, and in the workers of the page.
import { serve } from "./answers/aside.js";

if (typeof document === "undefined") serve();
else import("./main.js");
