# SPDX-License-Identifier: GPL-3.0-or-later
"""Files at random for "rwedge solve --input". What another program has written as CSV comes through as it was; whatever bytes a
file has, the command ends with a status of its own, and what it has written can be read.
    random_files.py PROGRAM FILES [SEED]"""
import csv
import io
import json
import random
import subprocess
import sys

CONTACT = ["--E1", "200e3", "--nu1", "0.3", "--theta", "0.01", "--f", "0.3"]
# files of users, right and wrong, that are changed
FILES = [text.encode(*encoding) for text, *encoding in [
    ("E1,nu1,E2,nu2,theta,a,P,Q,f,k\n200e3,0.3,inf,,0.01,2,2000,300,0.3,300\n1,0.2,3,0.1,0.1,0,1,0,0,1\n",),
    ('case,P,a,note\n1,1,1,"x, y"\n2,2000,1,"two\nlines"\n3,x,1,\n',), ("P,a\n1,1\n-1,1\n1e300,1\n\n,,\n",),
    ("E1;nu1;theta_deg;a;P\n1,5;0,3;1;2;3,5\n",), ("sep=;\nP;a\n1;2\n;\n",), ("P\ta\tü\r\n1\t2\t3\r\n",), ("P,a,ü\r1,2,3\r", "utf-16"),
    ("P,a,\ufeffYield stress\n1,1,1\n", "utf-8-sig"), ('Q,P,a\n1,2,1\n"x"y,1,1\n5\n"open',)]]
OPTIONS = [CONTACT, ["--format", "json"] + CONTACT, ["--decimal-comma"] + CONTACT, ["--format", "json", "--k", "300", "--yield-factor"] + CONTACT, []]


def solve(program, data, options):
    done = subprocess.run([program, "solve", "--input", "-", "--threads", "1"] + options, input=data, capture_output=True, timeout=60)
    return done.returncode, done.stdout, done.stderr


def random_text(draw):
    return "".join(draw.choice('",;\n\r\t \'x.é€𝄞0') for _ in range(draw.randint(0, 12)))


def is_cell(value, text):
    return str(value) == text.strip(" \t") if isinstance(value, (int, float)) else (value or "") == text


def check_round_trip(program, draw):
    rows = [["P", "a"] + ["n%d" % i for i in range(draw.randint(1, 5))]]
    for _ in range(draw.randint(1, 8)):
        rows.append(["100", "1"] + [random_text(draw) for _ in rows[0][2:]])
    written = io.StringIO(newline="")
    csv.writer(written).writerows(rows)
    data = written.getvalue().encode()
    status, out, err = solve(program, data, CONTACT)
    got = [row[:len(rows[0])] for row in csv.reader(io.StringIO(out.decode(), newline=""))]
    objects = json.loads(solve(program, data, ["--format", "json"] + CONTACT)[1])
    as_json = all(is_cell(row[name], cell) for row, cells in zip(objects, rows[1:]) for name, cell in zip(rows[0], cells))
    if status != 0 or got != rows or len(objects) != len(rows) - 1 or not as_json:
        sys.exit("FAILED: %r\n%r\nbecame %r (status %d, %r)" % (written.getvalue(), rows, got, status, err))


def changed(draw, data):
    """Some bytes are others, and the end is elsewhere."""
    data = bytearray(data)
    for _ in range(draw.randint(1, 8)):
        data[draw.randrange(len(data))] = draw.choice([draw.randrange(256), *b'",;\n\r'])
    return bytes(data[:draw.randint(1, len(data))] if draw.random() < 0.25 else data)


def check_any(program, draw):
    data, options = changed(draw, draw.choice(FILES)), draw.choice(OPTIONS)
    status, out, err = solve(program, data, options)
    good = status in (0, 1, 2) and (status == 0 or err.startswith(b"rwedge solve: "))
    if good and out:
        json.loads(out.decode()) if "json" in options else list(csv.reader(io.StringIO(out.decode(), newline="")))
    if not good:
        sys.exit("FAILED: status %d, %r for %r, %s" % (status, err, data, options))


def main(program, files, seed="2026"):
    draw = random.Random(seed)
    for _ in range(int(files) // 4):
        check_round_trip(program, draw)
    for _ in range(int(files)):
        check_any(program, draw)
    print("%s files" % files)


main(*sys.argv[1:])
