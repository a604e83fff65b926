/// A running `breccia studio` in a folder.

import {spawn} from "node:child_process";

export class Studio {
  /// Starts the studio; its address is known once it is served.
  static start(program, folder, options = []) {
    const process = spawn(program, ["studio", "--no-browser", ...options], {cwd: folder});
    return new Promise((resolve, reject) => {
      let text = "";
      process.stdout.setEncoding("utf8").on("data", (more) => {
        text += more;
        const address = /http:\/\/127\.0\.0\.1:\d+\/[0-9a-f]+\//.exec(text);
        if (address) resolve(Object.assign(new Studio(), {process, address: address[0]}));
      });
      process.stderr.setEncoding("utf8").on("data", (more) => { text += more; });
      process.once("close", () => reject(new Error(`the studio has ended: ${text}`)));
    });
  }

  /// Sends a signal, and waits for the end. Returns the exit code.
  end(signal = "SIGINT") {
    const ended = new Promise((resolve) => this.process.once("close", resolve));
    this.process.kill(signal);
    return ended;
  }

  /// The JSON that the studio answers.
  async ask(path, body = undefined) {
    const request = body === undefined ? {} : {method: "POST", body: JSON.stringify(body)};
    return (await fetch(this.address + path, request)).json();
  }
}
