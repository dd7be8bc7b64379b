# SPDX-License-Identifier: GPL-3.0-or-later
"""A LibreOffice without a window. It needs LibreOffice's Python module uno."""
import os
import signal
import subprocess
import sys
import time

import uno
from com.sun.star.beans import PropertyValue
from com.sun.star.connection import NoConnectException

LONGEST = 60  # seconds until it answers


def settings(**values):
    return tuple(PropertyValue(name, 0, value, 0) for name, value in values.items())


class Office:
    def __init__(self, folder):
        """Its profile is in the folder."""
        pipe = "rwedge%d" % os.getpid()
        self.process = subprocess.Popen(
            ["soffice", "-env:UserInstallation=file://" + os.path.join(os.path.abspath(folder), "profile"), "--headless",
             "--norestore", "--nologo", "--accept=pipe,name=%s;urp;" % pipe],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
        local = uno.getComponentContext()
        resolver = local.ServiceManager.createInstanceWithContext("com.sun.star.bridge.UnoUrlResolver", local)
        began = time.monotonic()
        while True:
            try:
                self.context = resolver.resolve("uno:pipe,name=%s;urp;StarOffice.ComponentContext" % pipe)
                break
            except NoConnectException:
                if self.process.poll() is not None or time.monotonic() - began > LONGEST:
                    self.end()
                    sys.exit("FAILED: LibreOffice does not start")
                time.sleep(0.05)

    def service(self, name):
        return self.context.ServiceManager.createInstanceWithContext(name, self.context)

    def open(self, url, **more):
        return self.service("com.sun.star.frame.Desktop").loadComponentFromURL(url, "_blank", 0, settings(Hidden=True, **more))

    def end(self):
        """With the programs that it started. It has nothing to save."""
        os.killpg(self.process.pid, signal.SIGKILL)
        self.process.wait()
