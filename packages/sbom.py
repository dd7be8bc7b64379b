# SPDX-License-Identifier: GPL-3.0-or-later
"""What a package is linked with, as SPDX 2.3.
    sbom.py VERSION SECONDS                         the source archive: what it is built with
    sbom.py VERSION SECONDS SOURCES KIND NAME...    what is compiled, for the system KIND: what is inside
"""
import json
import pathlib
import subprocess
import sys
import time

version, seconds = sys.argv[1], int(sys.argv[2])
sources = pathlib.Path(sys.argv[3]) if len(sys.argv) > 3 else None
kind, inside = (sys.argv[4], sys.argv[5:]) if sources else ("source", [])
LICENCES = {
    "gsl": "GPL-3.0-or-later",
    "lapack": "BSD-3-Clause",
    "musl": "MIT",
    "popt": "MIT",
    "jansson": "MIT",
    "libcsv": "LGPL-2.1-or-later",
    "libxlsxwriter": "BSD-2-Clause",
    "zlib": "Zlib",
}
# the oldest that the tests ran with: those of Debian 12
OLDEST = {"gsl": "2.7.1", "lapack": "3.11.0", "popt": "1.19", "jansson": "2.14", "libcsv": "3.0.3", "libxlsxwriter": "1.1.4"}
who = subprocess.run(  # who publishes this
    [sys.executable, "-B", pathlib.Path(__file__).with_name("who.py"), "name"], check=True, capture_output=True, text=True).stdout.strip()
OF_OTHER_SYSTEMS = {"musl", "zlib"}  # elsewhere they are the system's
RUN_TIMES = {  # Debian's packages of the compilers, whose run-time libraries are linked in
    "mingw-w64-x86-64-dev": "ZPL-2.1 AND MIT AND LicenseRef-Public-Domain",
    "gcc-mingw-w64-x86-64": "GPL-3.0-or-later WITH GCC-exception-3.1",
    "wasi-libc": "MIT AND CC0-1.0 AND BSD-2-Clause AND BSD-3-Clause",
    "libclang-rt-dev-wasm32": "Apache-2.0 WITH LLVM-exception",
}


def first_version(name):
    """As the first line of its Debian changelog says: name (version) ..."""
    line = (sources / name / "debian" / "changelog").read_text().split("\n", 1)[0]
    return line[line.index("(") + 1 : line.index(")")]


def installed_version(name):
    return subprocess.run(["dpkg-query", "-W", "-f", "${Version}", name], check=True, capture_output=True, text=True).stdout


def package(name, number, licence, supplier="Debian"):
    return {
        "SPDXID": f"SPDXRef-{name}",
        "name": name,
        "versionInfo": number,
        "supplier": f"Organization: {supplier}",
        "downloadLocation": "NOASSERTION",
        "filesAnalyzed": False,
        "licenseConcluded": licence,
        "licenseDeclared": licence,
        "copyrightText": "NOASSERTION",
    }


own = package("rwedge", version, "GPL-3.0-or-later", who)
if sources:
    parts = [package(name, installed_version(name), RUN_TIMES[name]) if name in RUN_TIMES else
             package(name, first_version(name), LICENCES[name]) for name in inside]
else:
    parts = [package(name, f"{OLDEST[name]} or newer", licence) for name, licence in LICENCES.items() if name not in OF_OTHER_SYSTEMS]
print(json.dumps({
    "spdxVersion": "SPDX-2.3",
    "dataLicense": "CC0-1.0",
    "SPDXID": "SPDXRef-DOCUMENT",
    "name": f"rwedge-{version}-{kind}",
    "documentNamespace": f"urn:rwedge:sbom:{kind}:{version}",
    "creationInfo": {
        "created": time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime(seconds)),
        "creators": [f"Organization: {who}"],
    },
    "packages": [own] + parts,
    **({"hasExtractedLicensingInfos": [
        {"licenseId": "LicenseRef-Public-Domain", "extractedText": "This file has no copyright assigned and is placed in the Public Domain."}
    ]} if "mingw-w64-x86-64-dev" in inside else {}),
    "relationships": [
        {"spdxElementId": "SPDXRef-DOCUMENT", "relationshipType": "DESCRIBES", "relatedSpdxElement": own["SPDXID"]}
    ] + [
        {"spdxElementId": own["SPDXID"], "relationshipType": "STATIC_LINK" if sources else "DYNAMIC_LINK",
         "relatedSpdxElement": part["SPDXID"]} for part in parts
    ],
}, indent=1))
