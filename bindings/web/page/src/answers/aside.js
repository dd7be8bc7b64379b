// SPDX-License-Identifier: GPL-3.0-or-later
// Long work is done aside, in a worker: typing goes on, and the next question ends the one before. The worker runs this page's script.
import { cycleOf } from "./cycle.js";
import { solveRows } from "./tables.js";

const tasks = { rows: solveRows, cycle: cycleOf };

function answerTo(task, values) {
    try {
        return tasks[task](...values);
    } catch (error) {
        return { complaint: `This cannot be computed: ${error.message}` };
    }
}

/** In the worker: answers what it is asked. */
export function serve() {
    self.onmessage = ({ data: [task, values] }) => self.postMessage(answerTo(task, values));
}

/** The script of the page, as it stands in it. */
const script = globalThis.document?.currentScript?.textContent;

const SECOND = 1000; // milliseconds

/** Questions of one kind, of which the last is answered. changed() follows each answer, and each second of waiting for one. */
export class Aside {
    constructor(task, changed) {
        Object.assign(this, { task, changed, busy: false, before: undefined, seconds: 0 });
    }

    start() {
        const address = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
        this.worker = new Worker(address);
        URL.revokeObjectURL(address);
    }

    /** The answer; nothing while it is worked on: busy is true then, and `before` has the last answer to another question. The same
     * question is not asked again. */
    ask(values) {
        const question = JSON.stringify(values);
        if (question !== this.question) this.begin(question, values);
        return this.answer;
    }

    begin(question, values) {
        this.end();
        if (!this.worker) this.start();
        Object.assign(this, { question, busy: true, before: this.answer ?? this.before, answer: undefined, seconds: 0 });
        this.clock = setInterval(() => {
            this.seconds++;
            this.changed();
        }, SECOND);
        this.worker.onmessage = ({ data }) => this.take(data);
        this.worker.onerror = () => this.take(answerTo(this.task, values)); // a browser without such workers waits
        this.worker.postMessage([this.task, values]);
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
