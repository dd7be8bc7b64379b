# SPDX-License-Identifier: GPL-3.0-or-later
"""sbom.py VERSION SECONDS SOURCES: what is linked into the programs for Windows, as SPDX 2.3."""
import json
import pathlib
import subprocess
import sys
import time

version, seconds, sources = sys.argv[1], int(sys.argv[2]), pathlib.Path(sys.argv[3])
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
RUN_TIMES = {  # Debian's packages of the compilers, whose run-time libraries are linked in
    "mingw-w64-x86-64-dev": "ZPL-2.1 AND MIT AND LicenseRef-Public-Domain",
    "gcc-mingw-w64-x86-64": "GPL-3.0-or-later WITH GCC-exception-3.1",
}


def first_version(name):
    """As the first line of its Debian changelog says: name (version) ..."""
    line = (sources / name / "debian" / "changelog").read_text().split("\n", 1)[0]
    return line[line.index("(") + 1 : line.index(")")]


def installed_version(name):
    return subprocess.run(["dpkg-query", "-W", "-f", "${Version}", name], check=True, capture_output=True, text=True).stdout


def package(name, number, licence):
    return {
        "SPDXID": f"SPDXRef-{name}",
        "name": name,
        "versionInfo": number,
        "downloadLocation": "NOASSERTION",
        "filesAnalyzed": False,
        "licenseConcluded": licence,
        "licenseDeclared": licence,
        "copyrightText": "NOASSERTION",
    }


inside = [package(name, first_version(name), licence) for name, licence in LICENCES.items()]
inside += [package(name, installed_version(name), licence) for name, licence in RUN_TIMES.items()]
own = package("rwedge", version, "GPL-3.0-or-later")
print(json.dumps({
    "spdxVersion": "SPDX-2.3",
    "dataLicense": "CC0-1.0",
    "SPDXID": "SPDXRef-DOCUMENT",
    "name": f"rwedge-{version}-windows-x64",
    "documentNamespace": f"urn:rwedge:sbom:windows-x64:{version}",
    "creationInfo": {
        "created": time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime(seconds)),
        "creators": ["Organization: The rwedge maintainers"],
    },
    "packages": [own] + inside,
    "hasExtractedLicensingInfos": [
        {"licenseId": "LicenseRef-Public-Domain", "extractedText": "This file has no copyright assigned and is placed in the Public Domain."}
    ],
    "relationships": [
        {"spdxElementId": "SPDXRef-DOCUMENT", "relationshipType": "DESCRIBES", "relatedSpdxElement": own["SPDXID"]}
    ] + [
        {"spdxElementId": own["SPDXID"], "relationshipType": "STATIC_LINK", "relatedSpdxElement": part["SPDXID"]} for part in inside
    ],
}, indent=1))
