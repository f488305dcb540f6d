"""Firefox for Selenium, without geckodriver, which Debian does not have: Firefox itself speaks WebDriver
BiDi (https://w3c.github.io/webdriver-bidi), and what tests ask of Selenium is said in that."""

import json
import pathlib
import re
import shutil
import socket
import subprocess
import tempfile
import time

from selenium import webdriver
from selenium.common.exceptions import JavascriptException, NoSuchElementException, WebDriverException
from selenium.webdriver.remote.command import Command
from wsproto import ConnectionType, WSConnection
from wsproto.events import AcceptConnection, Message, Ping, RejectConnection, Request

ELEMENT = "element-6066-11e4-a52e-4f735466cecf"  # W3C's key of an element in JSON

SETTINGS = {
    "app.update.disabledForTesting": True,
    "browser.shell.checkDefaultBrowser": False,
    "browser.startup.homepage_override.mstone": "ignore",
    "datareporting.policy.dataSubmissionEnabled": False,
    "dom.disable_beforeunload": False,
    "webgl.force-enabled": True,
}


class Socket:
    """A WebSocket on this machine that answers one question after the other."""

    LONGEST_S = 120

    def __init__(self, port):
        self.stream = socket.create_connection(("127.0.0.1", port), timeout=self.LONGEST_S)
        self.protocol = WSConnection(ConnectionType.CLIENT)
        self.ready = []     # events that nobody has asked for yet
        self.noticed = []   # what was told without a question
        self.count = 0
        self.text = ""
        self.send(Request(host=f"127.0.0.1:{port}", target="/session"))
        accepted = self.next_event()
        if isinstance(accepted, RejectConnection) or not isinstance(accepted, AcceptConnection):
            raise WebDriverException(f"Firefox does not listen: {accepted}")

    def send(self, event):
        self.stream.sendall(self.protocol.send(event))

    def next_event(self):
        while not self.ready:
            received = self.stream.recv(1 << 20)
            self.protocol.receive_data(received or None)
            self.ready = list(self.protocol.events())
        return self.ready.pop(0)

    def message(self):
        while True:
            event = self.next_event()
            if isinstance(event, Ping):
                self.send(event.response())
            elif isinstance(event, Message):
                self.text += event.data
                if event.message_finished:
                    text, self.text = self.text, ""
                    return json.loads(text)
            else:
                raise WebDriverException(f"Firefox has closed the connection: {event}")

    def ask(self, method, **parameters):
        self.count += 1
        self.send(Message(json.dumps({"id": self.count, "method": method, "params": parameters})))
        while True:
            answer = self.message()
            if answer.get("id") != self.count:
                self.noticed.append(answer)
            elif answer["type"] == "error":
                raise WebDriverException(f"{method}: {answer['error']}: {answer['message']}")
            else:
                return answer["result"]


def to_bidi(value):
    if isinstance(value, dict) and ELEMENT in value:
        return {"sharedId": value[ELEMENT]}
    if isinstance(value, dict):
        return {"type": "object", "value": [[key, to_bidi(one)] for key, one in value.items()]}
    if isinstance(value, (list, tuple)):
        return {"type": "array", "value": [to_bidi(one) for one in value]}
    if value is None:
        return {"type": "null"}
    if isinstance(value, bool):
        return {"type": "boolean", "value": value}
    return {"type": "string" if isinstance(value, str) else "number", "value": value}


def from_bidi(value):
    """Of what SCRIPT answers: elements, or JSON."""
    if value["type"] == "node":
        return {ELEMENT: value["sharedId"]}
    if value["type"] == "array":
        return [from_bidi(one) for one in value["value"]]
    return json.loads(value["value"])


# Numbers by the million are faster as one text than one by one.
SCRIPT = """async (...given) => {
  const result = await (function() { %s }).apply(null, given);
  const holds_elements = result instanceof Node || Array.isArray(result) && result[0] instanceof Node;
  return holds_elements ? result : JSON.stringify(result ?? null);
}"""
ASYNC_SCRIPT = "return new Promise(done => (function() { %s }).apply(null, [...arguments, done]))"

# As a user chooses it; the list itself is no part of the page.
CHOOSE = """const list = arguments[0].closest('select');
    list.value = arguments[0].value;
    for (const kind of ['input', 'change']) list.dispatchEvent(new Event(kind, {bubbles: true}));"""


class Firefox:
    """What Selenium sends its commands to."""

    keep_alive = True

    def __init__(self, settings):
        self.profile = tempfile.mkdtemp(prefix="ribbon-firefox-")
        lines = [f"user_pref({json.dumps(name)}, {json.dumps(value)});\n"
                 for name, value in {**SETTINGS, **settings}.items()]
        pathlib.Path(self.profile, "user.js").write_text("".join(lines))
        self.process = subprocess.Popen(
            ["firefox-esr", "--no-remote", "--profile", self.profile,
             "--remote-debugging-port=0", "--width=1200", "--height=900", "about:blank"],
            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, errors="replace")
        self.socket = Socket(self.port())
        self.socket.ask("session.new", capabilities={"alwaysMatch": {
            "unhandledPromptBehavior": {"default": "ignore"}}})
        self.socket.ask("session.subscribe", events=["log.entryAdded", "network.beforeRequestSent",
                                                     "browsingContext.userPromptOpened"])
        self.context = self.socket.ask("browsingContext.getTree")["contexts"][0]["context"]

    def port(self):
        for line in self.process.stderr:
            found = re.search(r"WebDriver BiDi listening on ws://127\.0\.0\.1:(\d+)", line)
            if found:
                return int(found[1])
        raise WebDriverException("Firefox has ended before it listened")

    def close(self):
        self.socket.stream.close()
        self.process.terminate()
        try:
            self.process.wait(20)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        self.process.stderr.close()
        shutil.rmtree(self.profile, ignore_errors=True)

    def in_context(self, method, **parameters):
        return self.socket.ask(method, context=self.context, **parameters)

    def script(self, text, *arguments):
        answer = self.socket.ask(
            "script.callFunction", functionDeclaration=SCRIPT % text, awaitPromise=True,
            target={"context": self.context}, arguments=[to_bidi(one) for one in arguments],
            userActivation=False)
        if answer["type"] == "exception":
            raise JavascriptException(answer["exceptionDetails"]["text"])
        return from_bidi(answer["result"])

    def find(self, using, value, below=None):
        locator = {"type": "xpath" if using == "xpath" else "css", "value": value}
        below = {"startNodes": [{"sharedId": below}]} if below else {}
        nodes = self.in_context("browsingContext.locateNodes", locator=locator, **below)["nodes"]
        return [{ELEMENT: node["sharedId"]} for node in nodes]

    def find_one(self, using, value, below=None):
        found = self.find(using, value, below)
        if not found:
            raise NoSuchElementException(value)
        return found[0]

    def act(self, actions):
        for source in actions:
            for action in source["actions"]:
                origin = action.get("origin")
                if isinstance(origin, dict):
                    action["origin"] = {"type": "element", "element": {"sharedId": origin[ELEMENT]}}
        self.in_context("input.performActions", actions=actions)

    def click(self, element):
        if self.script("return arguments[0].matches('option')", element):
            return self.script(CHOOSE, element)
        self.script("arguments[0].scrollIntoView({block: 'nearest'})", element)
        self.act([{"type": "pointer", "id": "mouse", "parameters": {"pointerType": "mouse"}, "actions": [
            {"type": "pointerMove", "x": 0, "y": 0, "duration": 0, "origin": element},
            {"type": "pointerDown", "button": 0}, {"type": "pointerUp", "button": 0}]}])
        return None

    def type_into(self, element, text):
        if self.script("return arguments[0].type === 'file'", element):
            return self.in_context("input.setFiles", element=to_bidi(element), files=[text])
        self.script("arguments[0].focus()", element)
        strokes = [{"type": kind, "value": key} for key in text for kind in ("keyDown", "keyUp")]
        self.act([{"type": "key", "id": "keyboard", "actions": strokes}])
        return None

    def execute(self, command, given):
        element = {ELEMENT: given["id"]} if given and "id" in given else None
        deeds = {
            Command.NEW_SESSION: lambda: {"sessionId": "bidi", "capabilities": {"browserName": "firefox"}},
            Command.QUIT: lambda: None,
            Command.GET: lambda: self.in_context(
                "browsingContext.navigate", url=given["url"], wait="complete") and None,
            Command.W3C_EXECUTE_SCRIPT: lambda: self.script(given["script"], *given["args"]),
            Command.W3C_EXECUTE_SCRIPT_ASYNC: lambda: self.script(
                ASYNC_SCRIPT % given["script"], *given["args"]),
            Command.FIND_ELEMENT: lambda: self.find_one(given["using"], given["value"]),
            Command.FIND_ELEMENTS: lambda: self.find(given["using"], given["value"]),
            Command.FIND_CHILD_ELEMENT: lambda: self.find_one(given["using"], given["value"], given["id"]),
            Command.FIND_CHILD_ELEMENTS: lambda: self.find(given["using"], given["value"], given["id"]),
            Command.CLICK_ELEMENT: lambda: self.click(element),
            Command.SEND_KEYS_TO_ELEMENT: lambda: self.type_into(element, given["text"]),
            Command.IS_ELEMENT_SELECTED: lambda: self.script("return arguments[0].selected", element),
            Command.IS_ELEMENT_ENABLED: lambda: self.script("return !arguments[0].disabled", element),
            Command.GET_ELEMENT_TAG_NAME: lambda: self.script("return arguments[0].localName", element),
            Command.GET_ELEMENT_ATTRIBUTE: lambda: self.script(
                "return arguments[0].getAttribute(arguments[1])", element, given["name"]),
            Command.GET_ELEMENT_TEXT: lambda: self.script(
                "return arguments[0].checkVisibility() ? arguments[0].innerText.trim() : ''", element),
            Command.GET_ELEMENT_RECT: lambda: self.script(
                "const {x, y, width, height} = arguments[0].getBoundingClientRect();"
                "return {x, y, width, height}", element),
            Command.W3C_ACTIONS: lambda: self.act(given["actions"]),
            Command.SCREENSHOT: lambda: self.in_context("browsingContext.captureScreenshot")["data"],
        }
        return {"value": deeds[command]()}


class FirefoxDriver(webdriver.Remote):
    """Selenium's driver of a Firefox that has what displays have, which only there has WebGL."""

    def __init__(self, calm, dark, with_picture):
        self.firefox = Firefox({
            "ui.prefersReducedMotion": int(calm),
            "layout.css.prefers-color-scheme.content-override": 0 if dark else 1,
            "webgl.disabled": not with_picture,
        })
        super().__init__(command_executor=self.firefox, options=webdriver.FirefoxOptions())
        self._is_remote = False  # files that it is given are on its own machine
        self.take_focus()

    def take_focus(self):
        """On a display without a window manager only a click of the mouse itself gives a page the keys."""
        for _ in range(50):
            subprocess.run(["xdotool", "mousemove", "600", "500", "click", "1"], check=True)
            if self.firefox.script("return document.hasFocus()"):
                return
            time.sleep(0.2)
        raise WebDriverException("Firefox does not take the focus")

    def quit(self):
        self.firefox.close()

    def find_errors(self):
        return [one["text"] for one in self.noticed("log.entryAdded") if one["level"] == "error"]

    def find_requests(self):
        return [one["request"]["url"] for one in self.noticed("network.beforeRequestSent")]

    def cover(self):
        """Nobody sees it any more: another tab comes to the front."""
        self.cover_tab = self.firefox.socket.ask("browsingContext.create", type="tab")["context"]

    def uncover(self):
        self.firefox.socket.ask("browsingContext.close", context=self.cover_tab)

    def set_screen(self, width, height):
        self.firefox.in_context("browsingContext.setViewport", viewport={"width": width, "height": height},
                                devicePixelRatio=2)

    def noticed(self, method):
        """What Firefox has told of this kind so far."""
        self.firefox.script("return null")  # what came before this answer has been read with it
        return [one["params"] for one in self.firefox.socket.noticed if one.get("method") == method]
