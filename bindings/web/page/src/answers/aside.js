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

/** Questions of one kind, of which the last is answered. answered() follows each answer. */
export class Aside {
    constructor(task, answered) {
        Object.assign(this, { task, answered, busy: false });
    }

    start() {
        const address = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
        this.worker = new Worker(address);
        URL.revokeObjectURL(address);
    }

    /** The answer; while it is worked on, busy is true, and it is that of the question before. The same question is not asked again. */
    ask(values) {
        const question = JSON.stringify(values);
        if (question !== this.question) this.begin(question, values);
        return this.answer;
    }

    begin(question, values) {
        if (this.busy) {
            this.worker.terminate();
            this.worker = null;
        }
        if (!this.worker) this.start();
        Object.assign(this, { question, busy: true });
        const take = (answer) => {
            Object.assign(this, { answer, busy: false });
            this.answered();
        };
        this.worker.onmessage = ({ data }) => take(data);
        this.worker.onerror = () => take(answerTo(this.task, values)); // a browser without such workers waits
        this.worker.postMessage([this.task, values]);
    }
}
