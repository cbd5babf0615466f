#!/usr/bin/python3
"""page.py PROGRAM FILE: does on the page of `mien live` what a person would, and tells what does not hold.

FILE is changed and saved; it must be a copy of configs/hello.yaml.
"""
import base64
import re
import signal
import subprocess
import sys
import time

from selenium.common.exceptions import StaleElementReferenceException

from browser import Keys, Page, start_live

MOST_DIFFERENCE = 12  # of 255, between the page's picture and a sketch's: soft shadows and fine hairs differ
KEY_LINE = "    - {at: 1.6s, express: smile"
SHORT_S = 5
failed = []


def check(words, holds, note=""):
    """Tells it; once something does not hold, nothing that follows is worth long waiting."""
    print(("holds   " if holds else "FAILED  ") + words, note if not holds else "", flush=True)
    if not holds:
        failed.append(words)
        Page.wait_s = SHORT_S


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


EDITOR = "mienLive.editor"
MISTAKES = "document.getElementById('mistakes').textContent"


def find_line(page, begin):
    return page.find(f"{EDITOR}.getText().split('\\n').findIndex((line) => line.startsWith({begin!r}))")


def go_to(page, frame):
    page.run(f"const field = document.getElementById('frame'); field.value = {frame}; field.dispatchEvent(new Event('change'))")
    page.until(f"mienLive.view.now.frame === {frame}")


def mistakes(page):
    line = find_line(page, KEY_LINE)
    page.run(f"const cm = {EDITOR}.cm; cm.focus(); cm.setCursor({line}, cm.getLine({line}).indexOf('smile') + 2)")
    before = page.find("mienLive.view.now.shapes.bytes > 0 && mienLive.state.doc")
    page.press("x")
    check("a mistake is counted", page.until(f"{MISTAKES} === '1 mistake'"))
    check("it is underlined", page.until("document.querySelectorAll('.finding_error').length > 0"))
    findings = page.find("JSON.stringify(mienLive.state.findings.map(({line, message}) => ({line, message})))")
    check("its line and words are mien's", f'"line":{line + 1}' in findings and "did you mean 'smile'" in findings, findings)
    check("screen readers hear it", page.until("/smxile/.test(document.getElementById('problem_news').textContent)"))
    page.press(Keys.ESCAPE)
    check("the face stays meanwhile", page.find("mienLive.state.doc") == before)
    page.press(Keys.BACKSPACE)
    check("mended, there is none", page.until(f"{MISTAKES} === 'no mistakes'"))


def face(page):
    picture = "mienLive.view.now.shapes.actors[0][0].places.reduce((sum, x, i) => (sum + x * (i % 97 + 1)) % 1000003, 0)"
    go_to(page, 38)
    before = page.find(picture)
    line = find_line(page, KEY_LINE)
    page.run(f"const cm = {EDITOR}.cm, text = cm.getLine({line}), at = text.indexOf('smile');"
             f"cm.replaceRange('anger', {{line: {line}, ch: at}}, {{line: {line}, ch: at + 5}})")
    check("another word is another face", page.until(f"({picture}) !== {before}"))
    page.run(f"{EDITOR}.cm.undo()")
    check("undone, it is the first face", page.until(f"({picture}) === {before}"))


def slider(page, file):
    before = read(file)
    page.run("document.getElementById('tab_pose').click()")
    page.run("document.getElementById('play').focus(); document.activeElement.blur()")
    page.press(Keys.HOME)
    for _ in range(2):
        page.press(Keys.PAGE_DOWN)
    for _ in range(12):
        page.press(Keys.ARROW_RIGHT)
    page.run("const s = document.querySelector('[data-move=\"brow.left.up\"]'); s.value = 0.5;"
             "s.dispatchEvent(new Event('input')); s.dispatchEvent(new Event('change'))")
    check("a slider poses the face", page.until("mienLive.view.pose && mienLive.view.pose.values['brow.left'].up === 0.5"))
    check("left and right are linked", page.find("mienLive.state.pose.values['brow.right'].up") == 0.5)
    page.run("document.getElementById('write_key').click()")
    check("a key is written", page.until("mienLive.state.isUnsaved && !mienLive.state.pose"))
    page.press("s", control=True)
    check("it is saved", page.until("!mienLive.state.isUnsaved"))
    lines, old = read(file).split("\n"), before.split("\n")
    added = [line for line in lines if line not in old]
    check("the file has one line more and nothing else", len(added) == 1 and [line for line in lines if line != added[0]] == old,
          str(added))
    check("which is the key", "brows: {up: 0.5" in added[0] or "up: 0.5" in added[0], str(added))
    write(file, before)
    check("what another program saves is loaded", page.until(f"{EDITOR}.getText() === {before!r}"))


def on_mark(page, mark, add):
    """The timeline is drawn anew when an answer comes: what was found just before that is taken again."""
    for _ in range(8):
        try:
            return add(page.act(), page.find(mark)).perform()
        except StaleElementReferenceException:
            time.sleep(0.3)
    raise RuntimeError(f"{mark} never stays")


def drag(page):
    page.until(f"{MISTAKES} === 'no mistakes' && document.querySelectorAll('.mark_key').length > 3")
    line = find_line(page, KEY_LINE)
    text = page.find(f"{EDITOR}.getText()")
    page.until("mienLive.state.isGood && !mienLive.timeline.isDragging")
    on_mark(page, "document.querySelectorAll('.mark_key')[2]",
            lambda act, key: act.click_and_hold(key).move_by_offset(20, 0).move_by_offset(10, 0).release())
    check("a dragged key changes its number", page.until(f"!{EDITOR}.cm.getLine({line}).startsWith({KEY_LINE!r})"))
    now = page.find(f"{EDITOR}.getText()").split("\n")
    check("and nothing else", sum(a != b for a, b in zip(now, text.split("\n"))) == 1)
    check("in seconds, as it was", "- {at: 1." in now[line] and "s, express: smile" in now[line], now[line])
    page.run(f"{EDITOR}.cm.undo()")
    check("undo takes it back", page.until("!mienLive.state.isUnsaved"))


def conflict(page, file):
    theirs = read(file).replace("title: Hello", "title: Theirs")
    page.run(f"{EDITOR}.cm.replaceRange('# mine\\n', {{line: 0, ch: 0}})")
    page.until("mienLive.state.isUnsaved")
    write(file, theirs)
    check("a save from outside is told", page.until("!document.getElementById('notice').hidden"))
    check("mine is still there", page.find(f"/# mine/.test({EDITOR}.getText())"))
    page.press("s", control=True)
    time.sleep(0.5)
    check("saving does not overwrite it silently", read(file) == theirs)
    page.run("document.getElementById('load_theirs').click()")
    check("theirs can be taken", page.until(f"{EDITOR}.getText() === {theirs!r}"))


def play(page):
    page.wait_for("mienLive.view.fetchAhead(0, 95); await new Promise((done) => setTimeout(done, 300))")
    page.run("document.getElementById('play').click()")
    check("it plays", page.until("mienLive.state.isPlaying && mienLive.stats.shown > 10"))
    page.run("document.getElementById('play').click()")
    check("and stops", page.until("!mienLive.state.isPlaying"))


def picture(page, program, file):
    for frame in (0, 60):
        go_to(page, frame)
        taken = page.wait_for(
            "const blob = await mienLive.view.takePicture();"
            "return new Promise((done) => { const reader = new FileReader(); reader.onload = () => done(reader.result);"
            "reader.readAsDataURL(blob); })")
        with open("page.png", "wb") as output:
            output.write(base64.b64decode(taken.split(",")[1]))
        subprocess.run([program, "still", file, "--at", f"{frame / 24}s", "--quality", "sketch", "-o", "still.png", "--quiet"],
                       check=True)
        # "1017.7 (0.0155)"; words instead where the sizes differ.
        told = subprocess.run(["compare", "-metric", "MAE", "page.png", "still.png", "null:"], stderr=subprocess.PIPE, text=True)
        share = re.search(r"\(([0-9.e-]+)\)", told.stderr)
        difference = 255 * float(share[1]) if share else 255
        check(f"the picture is the sketch's, frame {frame}", difference < MOST_DIFFERENCE, f"{difference:.1f} of 255")


def toggles(page):
    for name in ("wire", "guides", "landmarks", "areas", "beside"):
        answer = page.wait_for(f"await mienLive.view.setToggle('{name}', true); return mienLive.view.toggles.{name}")
        check(f"{name} can be shown", answer is True, str(answer))
        page.wait_for(f"await mienLive.view.setToggle('{name}', false)")
    for kind in ("rest", "key"):
        answer = page.wait_for(f"await mienLive.view.setToggle('ghost', '{kind}'); return Boolean(mienLive.view.ghost)")
        check(f"a ghost can be shown: {kind}", answer is True, str(answer))
    page.wait_for("await mienLive.view.setToggle('ghost', '')")


CONTROLS = {"button", "slider", "textbox", "searchbox", "combobox", "checkbox", "radio", "switch", "tab", "link", "spinbutton",
            "scrollbar", "separator", "listbox", "ColorWell"}


def accessibility(page):
    for tab in ("pose", "head", "make"):
        page.run(f"document.getElementById('tab_{tab}').click()")
        time.sleep(0.3)
        nodes = page.list_accessible()
        controls = [node for node in nodes if node["role"] in CONTROLS or node.get("focusable")]
        controls = [node for node in controls if node["role"] != "RootWebArea"]
        check(f"screen readers are given controls: {tab}", len(controls) > 40, str(len(controls)))
        nameless = [node for node in controls if not node["name"]]
        check(f"each has a name: {tab}", not nameless, str(nameless[:5]))
        vague = [node for node in controls if node["role"] in ("generic", "none", "")]
        check(f"each has a role: {tab}", not vague, str(vague[:5]))
        mute = [node for node in controls if node["role"] == "slider" and node["value"] in (None, "")]
        check(f"each slider tells its value: {tab}", not mute, str(mute[:5]))
        told = sum("pressed" in node for node in controls)
        toggles = page.find("[...document.querySelectorAll('[aria-pressed]')].filter((one) => one.getClientRects().length).length")
        check(f"each toggle tells its state: {tab}", told == toggles > 5, f"{told} of {toggles}")
        chosen = [node["name"] for node in nodes if node["role"] == "tab" and node.get("selected")]
        check(f"the tab tells that it is chosen: {tab}", [name.lower() for name in chosen] == [tab], str(chosen))
    live = page.find("""['message', 'connection', 'notice', 'problem_news', 'view_trouble', 'posing_what', 'tip_news'].filter((id) =>
      !document.getElementById(id).closest('[aria-live], [role=status], [role=alert], [role=log]'))""")
    check("news are in live regions", live == [], str(live))
    page.run("document.querySelector('[data-name=wire]').click()")
    check("a toggle that is pressed is told", page.until("mienLive.view.toggles.wire") and any(
        node["name"] == "Wire" and node.get("pressed") in (True, "true") for node in page.list_accessible()))
    page.run("document.querySelector('[data-name=wire]').click()")


def stage_keys(page):
    """Blinks and the keys of camera, light, background and head are as those of areas."""
    text = page.find(f"{EDITOR}.getText()")
    added = ("  blinks: [0.5s, 24f]\n  light: [{at: 0s, set: candle}, {at: 1s, set: studio}]\n"
             "  background: [{at: 1s, show: dark}]\n  head: [{at: 2s, age: old}]\n")
    other = re.sub(r"(?m)^  blinks: .*\n", added, text)
    page.run(f"{EDITOR}.load(arguments[0]); {EDITOR}.cm.replaceRange('#\\n', {{line: 0, ch: 0}}, undefined, '+input')", other)
    kinds = ("blink", "camera", "light", "background", "head")
    check("marks of all kinds are there", page.until(f"{kinds!r}".replace("(", "[").replace(")", "]")
          + ".every((kind) => document.querySelector(`.mark_${kind}:not([data-line='0'])`))"))
    for kind in kinds:
        mark = f"[...document.querySelectorAll('.mark_{kind}')].at(-1)"
        line = int(page.find(f"{mark}.dataset.line"))
        page.run(f"{mark}.scrollIntoView({{block: 'center'}})")
        on_mark(page, mark, lambda act, element: act.click(element))
        check(f"a click goes to its line: {kind}", page.until(f"{EDITOR}.cm.getCursor().line === {line - 1}"))
        before = page.find(f"{EDITOR}.cm.getLine({line - 1})")
        page.until("mienLive.state.isGood && !mienLive.timeline.isDragging")
        on_mark(page, mark, lambda act, element: act.click_and_hold(element).move_by_offset(12, 0)
                .move_by_offset(12, 0).release())
        check(f"a drag changes its time: {kind}", page.until(f"{EDITOR}.cm.getLine({line - 1}) !== arguments[0]".replace(
            "arguments[0]", repr(before))), before)
    page.run(f"{EDITOR}.load(arguments[0]); {EDITOR}.cm.replaceRange('#\\n', {{line: 0, ch: 0}}, undefined, '+input');"
             f"{EDITOR}.cm.undo()", text)
    page.until(f"{EDITOR}.getText() === arguments[0]".replace("arguments[0]", repr(text)))


def posed(page):
    """A face posed by hand is made as it is."""
    page.run("document.getElementById('tab_pose').click()")
    page.run("const s = document.querySelector('[data-move=\"lips.pucker\"], [data-move=\"brow.left.up\"]'); s.value = 0.8;"
             "s.dispatchEvent(new Event('input')); s.dispatchEvent(new Event('change'))")
    page.until("mienLive.state.pose")
    page.run("document.getElementById('tab_make').click()")
    check("what is posed is told", "posed by hand" in page.find("document.getElementById('make_face').textContent"))
    page.run("document.getElementById('make_still_sketch').click()")
    check("a face posed by hand is sketched", page.until("document.querySelector('.job a[href*=\"still_sketch.png\"]') !== null", 120))
    check("its end is told to all", page.until("/posed by hand: done/.test(document.getElementById('message').textContent)"))
    page.run("document.getElementById('posing_back').click()")


def make(page):
    page.run("document.getElementById('tab_make').click(); document.getElementById('make_sketch').click()")
    check("a clip is made", page.until("document.querySelector('.job a[href*=\"hello_sketch.mp4\"]') !== null", 120))


def main(program, file):
    process, address = start_live(program, file)
    page = Page(address)
    try:
        check("the page comes up with a face", page.is_ready())
        page.until(f"{MISTAKES} === 'no mistakes'")
        mistakes(page)
        face(page)
        slider(page, file)
        drag(page)
        conflict(page, file)
        play(page)
        picture(page, program, file)
        toggles(page)
        stage_keys(page)
        accessibility(page)
        posed(page)
        make(page)
        errors = [error for error in page.list_errors() if "409" not in error]
        check("the browser has nothing to complain of", not errors, "\n".join(errors))
    finally:
        page.close()
        process.send_signal(signal.SIGINT)
    check("the server ends cleanly", process.wait(20) == 0)
    print("all of it holds" if not failed else f"FAILED: {len(failed)}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2]))
