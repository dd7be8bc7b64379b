# SPDX-License-Identifier: GPL-3.0-or-later
"""Files at random for "rwedge solve --input", logs for "rwedge history", tests for "rwedge fretting --input". What another program
has written as CSV comes through as it was; whatever bytes a file has, the command ends with a status of its own, and what it has
written can be read.
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


# logs of instruments, right and wrong
LOGS = [text.encode(*encoding) for text, *encoding in [
    ("P,Q\n1000,100\n1000,-100\n900,50\n",), ("Rig 7\n# by hand\n\nTime;P;Q;sigma\ns;kN;kN;MPa\n0;1,2;0,1;5\n1;1,2;-0,1;-5\n",),
    ("t\tLoad(8801:Load) (kN)\tQ [N]\n0\t1.2\t100\n1\t1.1\t-100\n",), ("time  P  Q  tilt\n0 100 10 0.001\n1 120 -10 0.002\n", "utf-16"),
    ("P,M,Q,sigma\n1000,0,100,0\nNaN,1,2,3\n-9999,,0,0\n",), ("P [kN/mm],Q [lbf/in],x\n0.1,100,1\n0.1,-100,2\n", "cp1252")]]
LOG_OPTIONS = [[], ["--units", "mm,N,MPa"], ["--units", "mm,N,MPa", "--width", "8", "--drop"], ["--decimal-comma", "--units", "m,N,Pa", "--width", "1"],
               ["--units", "in,lbf,psi", "--column", "P=Load(8801:Load)", "--encoding", "cp1252"], ["--format", "json", "--until", "--drop"]]


# series of tests, right and wrong
TESTS = [text.encode(*encoding) for text, *encoding in [
    ("test,a,P,Q_max,Q_min,sigma_max,life_tested\n1,2,2000,300,,5,1e5\n2,1,1000,100,-50,,>1e6\n3,1,,100,,,\n",),
    ("Rig\n\ntest;a;p0;Q_max;M;swt_limit\n-;mm;MPa;N;N;MPa\n1;2;30;800;;0.1\n2;2;x;1;1;0\n",),
    ("a\tP\tQ_max\tloads\tsigma_before\n1\t1000\t\tnowhere.csv\t3\n1\t1000\t9\t\t3\n", "utf-16")]]
TEST_OPTIONS = [[], ["--fit-length"], ["--length", "0.1", "--format", "json"], ["--units", "mm,N,MPa", "--width", "8"],
                ["--decimal-comma"], ["--material", '{"sf": 900, "b": -0.1, "ef": 0.5, "c": -0.6}', "--format", "json", "--fit-length"]]


def solve(program, data, options, command=("solve", "--input", "-", "--threads", "1")):
    done = subprocess.run([program, *command] + options, input=data, capture_output=True, timeout=60)
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


def check_any(program, draw, files, ways, *command):
    data, options = changed(draw, draw.choice(files)), draw.choice(ways)
    status, out, err = solve(program, data, options, command)
    good = status in (0, 1, 2) and (status == 0 or err.startswith(b"rwedge %s: " % command[0].encode()))
    if good and out:
        json.loads(out.decode()) if "json" in options else list(csv.reader(io.StringIO(out.decode(), newline="")))
    if not good:
        sys.exit("FAILED: status %d, %r for %r, %s" % (status, err, data, options))


def main(program, files, seed="2026"):
    draw = random.Random(seed)
    for _ in range(int(files) // 4):
        check_round_trip(program, draw)
    for _ in range(int(files)):
        check_any(program, draw, FILES, OPTIONS, "solve", "--input", "-", "--threads", "1")
        check_any(program, draw, LOGS, LOG_OPTIONS, "history", "-", *CONTACT, "--a", "2")
        check_any(program, draw, TESTS, TEST_OPTIONS, "fretting", "--input", "-", *CONTACT)
    print("%s files" % files)


main(*sys.argv[1:])
