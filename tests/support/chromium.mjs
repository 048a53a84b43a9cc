// A headless Chromium that is driven through a pipe, without any package: open(file) gives a page.
import {spawn} from "node:child_process";
import {mkdtempSync, rmSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {pathToFileURL} from "node:url";

const flags = [
  "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-extensions",
  "--disable-background-networking", "--disable-component-update", "--disable-sync", "--hide-scrollbars",
  "--disable-dev-shm-usage", "--remote-debugging-pipe",
];

class Page {
  problems = [];  // errors and warnings of the console, exceptions, refused loads
  #answers = new Map();
  #waiting = new Map();
  #number = 0;
  #session;

  constructor(browser, folder) {
    this.browser = browser;
    this.folder = folder;
    let rest = "";
    browser.stdio[4].setEncoding("utf8").on("data", (text) => {
      const messages = (rest + text).split("\0");
      rest = messages.pop();
      for (const message of messages) this.#take(JSON.parse(message));
    });
  }

  #take(message) {
    if (message.id) {
      const {resolve, reject} = this.#answers.get(message.id);
      if (message.error) reject(new Error(message.error.message)); else resolve(message.result);
      return;
    }
    if (message.method === "Runtime.exceptionThrown")
      this.problems.push(message.params.exceptionDetails.exception?.description ?? "exception");
    if (message.method === "Runtime.consoleAPICalled" && message.params.type !== "log")
      this.problems.push(message.params.args.map((arg) => arg.value ?? arg.description).join(" "));
    if (message.method === "Log.entryAdded") this.problems.push(message.params.entry.text);
    if (message.method === "Network.requestWillBeSent") {
      const {url} = message.params.request;
      if (!url.startsWith("file:") && !url.startsWith("data:")) this.problems.push("asked for " + url);
    }
    this.#waiting.get(message.method)?.();
  }

  send(method, params = {}) {
    const id = ++this.#number;
    this.browser.stdio[3].write(JSON.stringify({id, method, params, sessionId: this.#session}) + "\0");
    return new Promise((resolve, reject) => this.#answers.set(id, {resolve, reject}));
  }

  event(method) {
    return new Promise((resolve) => this.#waiting.set(method, resolve));
  }

  async open(file, width, height) {
    const {targetId} = await this.send("Target.createTarget", {url: "about:blank"});
    this.#session = (await this.send("Target.attachToTarget", {targetId, flatten: true})).sessionId;
    for (const domain of ["Page", "Runtime", "Log", "Network"]) await this.send(domain + ".enable");
    await this.send("Emulation.setDeviceMetricsOverride", {width, height, deviceScaleFactor: 1, mobile: false});
    const loaded = this.event("Page.loadEventFired");
    await this.send("Page.navigate", {url: pathToFileURL(file).href});
    await loaded;
  }

  // The value of an expression, which may be a promise.
  async value(expression) {
    const {result, exceptionDetails} = await this.send("Runtime.evaluate", {
      expression, returnByValue: true, awaitPromise: true,
    });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? expression);
    return result.value;
  }

  // Waits until an expression is true.
  async until(expression, seconds = 30) {
    for (const end = Date.now() + 1000 * seconds; !(await this.value(expression));) {
      if (Date.now() > end) throw new Error("never came true: " + expression);
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
  }

  async press(key, modifiers = 0) {
    const text = key.length === 1 ? key : undefined;
    await this.send("Input.dispatchKeyEvent", {type: "keyDown", key, text, modifiers});
    await this.send("Input.dispatchKeyEvent", {type: "keyUp", key, modifiers});
  }

  async mouse(type, x, y) {
    await this.send("Input.dispatchMouseEvent", {type, x, y, button: "left", buttons: 1, clickCount: 1});
  }

  async picture(clip) {
    const {data} = await this.send("Page.captureScreenshot", {format: "png", clip, captureBeyondViewport: true});
    return Buffer.from(data, "base64");
  }

  async close() {
    const gone = new Promise((resolve) => this.browser.once("exit", resolve));
    this.#session = undefined;
    this.send("Browser.close").catch(() => {});
    await gone;
    rmSync(this.folder, {recursive: true, force: true, maxRetries: 10, retryDelay: 100});
  }
}

export async function open(program, file, width = 1100, height = 900) {
  const folder = mkdtempSync(join(tmpdir(), "chromium-"));
  const browser = spawn(program, [...flags, "--user-data-dir=" + folder], {
    stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"],
  });
  const page = new Page(browser, folder);
  await page.open(file, width, height);
  return page;
}
