// SPDX-License-Identifier: GPL-3.0-or-later
// Long work is done aside, in a worker: typing goes on, and the next question ends the one before. The worker runs this page's script.
import { cycleOf } from "./last_cycle.js";
import { solveRows } from "./tables.js";

/** told() hears the share that is done, where that is known. */
const tasks = {
    rows: (told, ...values) => solveRows(...values),
    cycle: (told, texts, text, sign, times, chosen, crack = null) => cycleOf(texts, text, sign, times, chosen, crack, told),
};

function answerTo(task, values, told) {
    try {
        return tasks[task](told, ...values);
    } catch (error) {
        return { complaint: `This cannot be computed: ${error.message}` };
    }
}

const OFTEN = 250; // milliseconds from one share to the next

/** In the worker: answers what it is asked, with shares before. */
export function serve() {
    self.onmessage = ({ data: [task, values] }) => {
        let last = performance.now();
        const told = (share) => {
            if (performance.now() < last + OFTEN && share < 1) return;
            last = performance.now();
            self.postMessage({ share });
        };
        self.postMessage({ answer: answerTo(task, values, told) });
    };
}

/** The script of the page, as it stands in it. */
const script = globalThis.document?.currentScript?.textContent;

const SECOND = 1000; // milliseconds

/** Questions of one kind, of which the last is answered. changed() follows each answer, and each second of waiting for one. */
export class Aside {
    constructor(task, changed) {
        Object.assign(this, { task, changed, busy: false, before: undefined, seconds: 0, share: undefined });
    }

    start() {
        const address = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
        this.worker = new Worker(address);
        URL.revokeObjectURL(address);
    }

    /** The answer; nothing while it is worked on: busy is true then, `share` the part that is done where it is known, and `before`
     * has the last answer to another question. The same question is not asked again. */
    ask(values) {
        const question = JSON.stringify(values);
        if (question !== this.question) this.begin(question, values);
        return this.answer;
    }

    begin(question, values) {
        this.end();
        if (!this.worker) this.start();
        Object.assign(this, { question, busy: true, before: this.answer ?? this.before, answer: undefined, seconds: 0, share: undefined });
        this.clock = setInterval(() => {
            this.seconds++;
            this.changed();
        }, SECOND);
        this.worker.onmessage = ({ data }) => ("answer" in data ? this.take(data.answer) : this.hear(data.share));
        this.worker.onerror = () => this.take(answerTo(this.task, values, () => {})); // a browser without such workers waits
        this.worker.postMessage([this.task, values]);
    }

    /** Of the loads that are gone through; nothing is known of what follows them. */
    hear(share) {
        this.share = share < 1 ? share : undefined;
        this.changed();
    }

    take(answer) {
        clearInterval(this.clock);
        Object.assign(this, { answer, busy: false });
        this.changed();
    }

    /** Ends what is worked on; its worker goes. */
    end() {
        if (!this.busy) return;
        clearInterval(this.clock);
        this.worker.terminate();
        Object.assign(this, { worker: null, busy: false });
    }

    stop() {
        this.end();
        this.take({ complaint: "Stopped. A change of the inputs computes anew." });
    }
}
