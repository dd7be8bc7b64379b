// SPDX-License-Identifier: GPL-3.0-or-later
// The package as it is installed: numbers, arrays, errors, objects. That the numbers are those of C is answer.mjs.
import assert from "node:assert/strict";
import test from "node:test";

// counts what is freed by the collector of garbage
let collected = 0;
globalThis.FinalizationRegistry = class extends FinalizationRegistry {
    constructor(free) {
        super((held) => {
            collected++;
            free(held);
        });
    }
};
const rwedge = await import("rwedge");

const { Contact, RwedgeError, Series } = rwedge;
const made = () => new Contact(0.01, 2, 1.8e-5, 0.3);
const refused = (status, message) => (error) => error instanceof RwedgeError && error.status === status && message.test(error.message);

test("formulas take numbers and arrays", () => {
    assert.equal(rwedge.load(0), 2); // the sharp wedge: P = 2 theta b/A
    assert.deepEqual(rwedge.load(Float64Array.of(0, 0)), Float64Array.of(2, 2));
    const f = [0.1, 0.2], limits = f.map((friction) => rwedge.elastic_limit(0.25, friction, 0.3));
    assert.deepEqual(rwedge.elastic_limit(0.25, f, 0.3), Float64Array.from(limits));
    assert.deepEqual(rwedge.elastic_limit([0.25, 0.25], Float32Array.from([0.5, 0.25]), 0.3),
        Float64Array.of(rwedge.elastic_limit(0.25, 0.5, 0.3), rwedge.elastic_limit(0.25, 0.25, 0.3)));
    assert.deepEqual(rwedge.load([]), new Float64Array(0));
    assert.equal(rwedge.load(-1), NaN);
    assert.deepEqual(rwedge.load([0, -1]), Float64Array.of(2, NaN));
});

test("several results have their names in the header", () => {
    const { limit, x, y } = rwedge.yield_point(0.25, 0.1, 0.3);
    assert.equal(limit, rwedge.elastic_limit(0.25, 0.1, 0.3));
    assert.deepEqual(rwedge.yield_point([0.25, 0.25], 0.1, 0.3), { limit: Float64Array.of(limit, limit), x: Float64Array.of(x, x), y: Float64Array.of(y, y) });
    assert.deepEqual(rwedge.stresses(0.25, 0.3, 0, 0.5, 0.1), rwedge.stress(0.25, 0.3, 0, 0.5, 0.1));
    assert.deepEqual(rwedge.stresses(0.25, 0.3, 0, [0.5, -1], 0.1), rwedge.stress(0.25, 0.3, 0, [0.5, -1], 0.1));
    assert.match(rwedge.version(), /^\d+\.\d+\.\d+$/);
    assert.equal(rwedge.validity_text(3), "");
});

test("what is wrong is said", () => {
    assert.throws(() => rwedge.stress(0.25, 0.3, 0, 0.5, -1), refused("RWEDGE_EDOMAIN", /^stress\(\): an argument is outside its domain: y = -1 \(0, or 1e-60 to 1e60, not the apex/));
    assert.throws(() => rwedge.stresses(0.25, 0.3, 0, [0, 1], [1, -1]), refused("RWEDGE_EDOMAIN", /: y\[1\] = -1 \(/));
    assert.throws(() => rwedge.stress(0, 0.3, 0, 0, 0), refused("RWEDGE_EDOMAIN", /: alpha = 0 \(.*\), y = 0 \(/));
    assert.throws(() => new Contact(0.01, 2, -1, 0.3), refused("RWEDGE_EDOMAIN", /A = -1/));
    assert.throws(() => Contact.create_profile([0, 1], [0.1, 0], 1e-4, 0.5), refused("RWEDGE_EDOMAIN", /slope/)); // not convex
    assert.throws(() => made().load(1000, 900), refused("RWEDGE_ESLIDING", /friction times the normal force: P = 1000 \(.*\), Q = 900 \(.*\|Q\| <= f P\)$/));
    assert.throws(() => made().edges(), refused("RWEDGE_EABSENT", /^contact_edges\(\): /));
    assert.throws(() => Series.fit([0.1, 0.1, 0.1], [1, 1, 1], 3), refused("RWEDGE_ERANK", /^series_fit\(\): /));
    assert.throws(() => rwedge.load(), { name: "TypeError", message: "load(): alpha must be a number, not undefined" });
    assert.throws(() => rwedge.load("1"), TypeError);
    assert.throws(() => rwedge.load(["1"]), TypeError);
    assert.throws(() => rwedge.coefficient(0.25, 1.5), { name: "TypeError", message: "coefficient(): n must be a whole number below 2^31, not 1.5" });
    assert.throws(() => rwedge.coefficient(0.25, [1, 1.5]), TypeError);
    assert.throws(() => rwedge.coefficient(0.25, Float64Array.of(1, 2 ** 31)), TypeError);
    assert.throws(() => rwedge.load(10n), TypeError);
    assert.throws(() => rwedge.elastic_limit([0.1, 0.2], [0.1], 0.3), /arrays of 2 and 1 numbers/);
    assert.throws(() => made().stress_history([1, 2], [0], [0, 0], [0, 0], [0], [1]), /M has 1 numbers/);
    assert.throws(() => rwedge.criterion_field(12, [2e5], 2, [1, 2, 3], [1, 2, 3], [1, 2, 3], 0.3, 0), /sxx must have loads \* n numbers/);
    assert.throws(() => rwedge.criterion_field(12, [2e5], 0, [], [], [], 0.3, 0), Error);
    assert.throws(() => rwedge.criterion_field(12, [2e5], -1, [1], [1], [1], 0.3, 0), Error);
    assert.throws(() => rwedge.criterion(rwedge.Measure.SWT, [], [1], [1], [1], 0.3, 0), /constants has 0 numbers/);
});

test("an array that is refused says at which element", () => {
    assert.throws(() => rwedge.yield_point([0.25, -1], 0.1, 0.3), refused("RWEDGE_EDOMAIN", /: alpha\[1\] = -1 \(/));
    assert.throws(() => rwedge.load([0, undefined]), { name: "TypeError", message: "load(): alpha[1] must be a number, not undefined" });
    const contact = made();
    contact.load(1000, 0);
    assert.throws(() => contact.slip([0.1, 50]), refused("RWEDGE_EDOMAIN", /: x\[1\] = 50 \(.*\|x\| <= b\)/));
    assert.throws(() => rwedge.stresses(0, 0.3, 0, [1, 0], [1, 0]), refused("RWEDGE_EDOMAIN", /x\[1\] = 0 \(.*, y\[1\] = 0 \(/));
});

test("what has no closed form, or does not exist, says why", () => {
    const contact = made();
    assert.throws(() => contact.edges(), refused("RWEDGE_EABSENT", /, when separated$/));
    contact.apply(1000, 100, 0, 0);
    assert.throws(() => contact.apply(1000, 100, 0, 500), refused("RWEDGE_EPATH", /, the two edges would slip in opposite directions/));
    const pad = new Contact(0.1, 17.8, 4.81e-5, 0.65);
    assert.throws(() => pad.permanent_stick(300, 0, 0, 0, 300, 0, 0, 900), refused("RWEDGE_EPATH", /, where the edges slip/));
});

test("a cycle is made of a contact, which it outlives", () => {
    const contact = made();
    contact.load(1000, 0);
    contact.load(1000, 100);
    const cycle = new rwedge.Cycle(contact, [1000, 1000], [0, 0], [-100, 100], [0, 0]), b = contact.half_width();
    const before = cycle.friction([0, 0.99 * b]), { left, right } = cycle.permanent_stick();
    assert.deepEqual({ left, right }, contact.permanent_stick(1000, 0, -100, 0, 1000, 0, 100, 0));
    contact.free();
    assert.equal(cycle.loads(), 2);
    assert.ok(before.slip_range[0] === 0 && before.slip_range[1] > 0);
    assert.deepEqual(cycle.friction([0, 0.99 * b]), before);
    assert.equal(cycle.stresses([0, b], [1, 1]).sxx.length, 4);
    cycle.free();
    assert.throws(() => cycle.loads(), { name: "TypeError", message: "this Cycle has been freed" });
    assert.throws(() => new rwedge.Cycle(new Series(0.25, 5), [1], [0], [0], [0]), { name: "TypeError", message: "this Series is no contact" });
});

test("a method of another object is refused", () => {
    assert.throws(() => Contact.prototype.half_width.call(new Series(0.25, 5)), { name: "TypeError", message: "this Series is no contact" });
});

test("a formula of numbers takes about as long as for a point of an array", () => {
    const x = Float64Array.from({ length: 200000 }, (_, i) => 1e-6 * i);
    const fastest = (run) => Math.min(...Array.from({ length: 7 }, () => {
        const began = process.cpuUsage();
        run();
        return process.cpuUsage(began).user / x.length;
    }));
    const each = fastest(() => x.forEach((place) => rwedge.pressure(0.25, place))), all = fastest(() => rwedge.pressure(0.25, x));
    assert.ok(each < 8 * all, `${each} us, ${all} us in an array`); // 1.2 alone, 4 after the calls of the tests above
});

test("a status has its number and its words", () => {
    const words = Object.values(rwedge.statuses).map(rwedge.strerror);
    assert.equal(words[0], "success");
    assert.equal(new Set([...words, rwedge.strerror(-1)]).size, words.length + 1); // each has its own
    assert.throws(() => made().load(1000, 900), (error) => error.message.includes(rwedge.strerror(rwedge.statuses[error.status])));
    assert.throws(() => {
        rwedge.statuses.RWEDGE_OK = 1;
    }, TypeError);
});

test("a contact remembers its loads", () => {
    const contact = made();
    contact.load(1000, 0);
    contact.load(1000, 200);
    const twin = contact.copy(), restored = Contact.restore(contact.state());
    assert.ok(twin instanceof Contact && restored instanceof Contact);
    twin.load(1000, -200);
    assert.deepEqual(contact.loads(), { P: 1000, M: 0, Q: 200, sigma: 0 });
    const places = [-1, 0, 0.5], before = contact.tractions(places);
    assert.deepEqual(restored.tractions(places), before);
    assert.deepEqual(contact.tractions(0), { p: before.p[1], q: before.q[1] });
    assert.deepEqual(contact.stresses(places, 1).sxx[1], contact.stresses(0, 1).sxx);
    const history = restored.stress_history([1000], [0], [-200], [0], places, [1, 1, 1]);
    assert.deepEqual(history, twin.stresses(places, 1));
    assert.equal(contact.obstacle(1000, 0, 200, 0), "");
    assert.equal(typeof contact.memory(), "number");
    // two loads at three points
    const { sxx, syy, txy } = made().stress_history([1000, 1000], [0, 0], [0, 200], [0, 0], places, [1, 1, 1]);
    const cycle = rwedge.criterion_field(rwedge.Measure.SWT, [2e5], 2, sxx, syy, txy, 0.3, 0);
    const at = (stress) => [stress[1], stress[4]];
    assert.equal(cycle.value.length, 3);
    assert.equal(cycle.value[1], rwedge.criterion(rwedge.Measure.SWT, [2e5], at(sxx), at(syy), at(txy), 0.3, 0).value);
    const metal = [2e5, 475, -0.078, 0.6, -0.62, 0], damage = rwedge.damage(rwedge.Measure.SWT, metal, at(sxx), at(syy), at(txy), 0.3, 0);
    assert.equal(damage.plane.length, 2);
    assert.equal(rwedge.damage_field(1, metal, 2, sxx, syy, txy, 0.3, 0).plane.length, 6);
    assert.ok(rwedge.life(1, metal, 1) > 0);
});

test("a class may be derived", () => {
    class Pad extends Contact {}
    const pad = new Pad(0.01, 2, 1.8e-5, 0.3);
    assert.ok(pad.copy() instanceof Pad && Pad.restore(pad.state()) instanceof Pad && Pad.create_flat(0.5, 10, 1e-4, 0.5) instanceof Pad);
});

test("a freed object is of no use, and may be freed again", () => {
    const contact = made();
    contact.free();
    contact.free();
    assert.throws(() => contact.half_width(), { name: "TypeError", message: "this Contact has been freed" });
    assert.throws(() => contact.copy(), TypeError);
    assert.throws(() => Contact.prototype.half_width.call({}), TypeError);
});

test("the memory grows where it must, and arrays of before stay", () => {
    const x = new Float64Array(4e5).fill(0.5), y = new Float64Array(4e5).fill(1);
    const small = rwedge.stresses(0.25, 0.3, 0, [0.5], [1]), large = rwedge.stresses(0.25, 0.3, 0, x, y);
    assert.equal(large.sxx[399999], small.sxx[0]);
    assert.throws(() => new Series(0.25, 2 ** 24 + 1), refused("RWEDGE_ERANGE", /./));
    assert.deepEqual(large.syy.slice(0, 1), small.syy);
});

test("what is no longer used is freed, and once", { skip: typeof gc === "undefined" }, async () => {
    const collect = async () => {
        gc();
        await new Promise((resolve) => setTimeout(resolve, 5)); // objects are freed between tasks
    };
    await collect();
    const before = collected;
    for (let i = 0; i < 100; i++) made().free();
    await collect();
    assert.equal(collected, before);
    for (let i = 0; i < 100; i++) made();
    await collect();
    assert.ok(collected - before > 90, `${collected - before} of 100`);
});
