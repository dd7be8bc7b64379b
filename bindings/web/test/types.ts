// SPDX-License-Identifier: GPL-3.0-or-later
// What a program in TypeScript may write. It is checked, not run.
import * as rwedge from "rwedge";
import { Contact, RwedgeError, Series, elastic_limit, type Numbers } from "rwedge";

const one: number = elastic_limit(0.25, 0.1, 0.3);
const many: Float64Array = elastic_limit(0.25, new Float64Array(3), 0.3);
const single: Float64Array = rwedge.load(new Float32Array(3));
const listed: Numbers = [0.1, 0.2];
const point: { limit: number; x: number; y: number } = rwedge.yield_point(0.25, 0.1, 0.3);
const field: { sxx: Float64Array; syy: Float64Array; txy: Float64Array } = rwedge.stresses(0.25, 0.3, 0, listed, 1);
const contact = new Contact(0.01, 2, 1.8e-5, 0.3);
const nothing: void = contact.load(1000, 200);
const width: number = contact.half_width();
const { left, right }: { left: number; right: number } = contact.edges();
const here: { p: number; q: number } = contact.tractions(0);
const there: { p: Float64Array; q: Float64Array } = contact.tractions(listed);
const twin: Contact = Contact.restore(contact.state());
const cycle: { value: Float64Array } = rwedge.criterion_field(12, [2e5], 2, listed, listed, listed, 0.3, 0);
const fitted: Series = Series.fit(listed, listed, 2);
const said: string = rwedge.validity_text(1) + contact.obstacle(1, 0, 0, 0);
const status: keyof typeof rwedge.statuses = new RwedgeError().status;
const reason: string = rwedge.strerror(rwedge.statuses[status]);
const outside: 1 = rwedge.statuses.RWEDGE_EDOMAIN;
contact.free();

// @ts-expect-error: an argument is missing
elastic_limit(0.25, 0.1);
// @ts-expect-error: a text is no number
elastic_limit("0.25", 0.1, 0.3);
// @ts-expect-error: the results of numbers are numbers
const wrong: Float64Array = elastic_limit(0.25, 0.1, 0.3);
// @ts-expect-error: a method needs its object
Contact.half_width();
// @ts-expect-error: no such status
rwedge.statuses.RWEDGE_EHALF;
// @ts-expect-error: no such function
rwedge.half_of_it(1);

export { one, many, single, point, field, nothing, width, left, right, here, there, twin, cycle, fitted, said, status, reason, outside, wrong };
