"""Draws and ties knots in a page as a person would: mouse, keys, touch.

draw_in_browser.py PAGES FOLDER   (PAGES holds sketch.html, and own.html, reef.html and metres.html, which were
                                   written for a scene; pictures and what is saved go to FOLDER)
"""

import base64
import math
import pathlib
import sys
import time
import unittest

from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import Select

from browser_page import OpenedPage

PAGES, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])

# An overhand knot round what stands in the middle, in drawing units.
OVERHAND = [(-640, 570), (-510, 545), (-285, 425), (-160, 395), (-70, 410), (75, 510), (150, 520), (250, 460),
            (345, 350), (410, 225), (440, 105), (440, -15), (405, -140), (335, -250), (240, -340), (125, -400),
            (5, -420), (-120, -400), (-240, -340), (-340, -245), (-405, -135), (-435, -10), (-430, 110),
            (-395, 240), (-330, 370), (-240, 475), (-150, 520), (-70, 510), (85, 410), (160, 400), (280, 425),
            (515, 535), (650, 560)]


class Sketch(OpenedPage):
    """A page in which nothing has been drawn yet."""

    page = PAGES / "sketch.html"
    pictures = FOLDER

    def on_screen(self, place):
        """Offsets from the board's middle, as the mouse takes them."""
        x, y = self.script("return board.to_screen(arguments[0])", list(place))
        board = self.find("board").size
        return round(x - board["width"] / 2), round(y - board["height"] / 2)

    def draw(self, places):
        """With the mouse, in one stroke; on a board that shows as much."""
        self.script("""
            const box = box_around([board.box.slice(0, 2), board.box.slice(2), ...arguments[0]]);
            if (box.some((value, i) => value !== board.box[i])) board.fit(box);""", [list(place) for place in places])
        paper = self.find("paper")
        actions = ActionChains(self.browser, duration=5)
        actions.move_to_element_with_offset(paper, *self.on_screen(places[0])).click_and_hold()
        for a, b in zip(places, places[1:]):
            for share in (0.5, 1):
                place = [p + share * (q - p) for p, q in zip(a, b)]
                actions.move_to_element_with_offset(paper, *self.on_screen(place))
        actions.release().perform()
        self.wait_for_answer()

    def click(self, place):
        ActionChains(self.browser).move_to_element_with_offset(
            self.find("paper"), *self.on_screen(place)).click().perform()
        self.wait_for_answer()

    def wait_for_answer(self):
        self.wait_for(lambda: self.script(
            "return states.state.points.length < 2 || answer !== null"), "no answer to the drawing")

    def points(self):
        return self.script("return states.state.points")

    def letters(self):
        return self.script("return letters_of(states.state.told)")

    def crossings(self):
        return self.browser.find_elements(By.CSS_SELECTOR, "#crossings button")

    def passes(self):
        return self.browser.find_elements(By.CSS_SELECTOR, "#passes button")

    def knot(self):
        return self.find("knot").text

    def begin_with(self, text):
        Select(self.find("ready")).select_by_visible_text(text)
        self.wait_for_answer()

    def tie(self, frames=0):
        """Until it has ended, or until there are so many frames."""
        self.find("tie").click()
        self.wait_for(lambda: self.status().startswith("T"), "it does not begin to tie")
        if frames:
            self.wait_for(lambda: self.script("return recording?.frames ?? 0") >= frames, "it does not tie")
        else:
            self.wait_for(lambda: self.status().startswith("Tied: "), "it is not tied")

    def save(self, button, *names, into="other"):
        """What the page hands out; into a folder."""
        self.script("""
            window.saved = {};
            window.save = (name, content) => {
              const reader = new FileReader();
              reader.onload = () => { saved[name] = reader.result.split(',')[1]; };
              reader.readAsDataURL(new Blob([content]));
            };""")
        self.find(button).click()
        self.wait_for(lambda: self.script("return Object.keys(saved).length") == len(names), "not all was saved")
        saved = self.script("return saved")
        self.assertEqual(sorted(saved), sorted(names))
        folder = FOLDER / into
        folder.mkdir(parents=True, exist_ok=True)
        for name, content in saved.items():
            (folder / name).write_bytes(base64.b64decode(content))

    def stop(self):
        """Where it has not ended meanwhile."""
        self.script("document.getElementById('stop').click()")
        self.wait_for(lambda: self.status().startswith("Tied: "), "it does not stop")

    def would_ask_before_closing(self):
        return self.script("""
            const closing = new Event('beforeunload', {cancelable: true});
            dispatchEvent(closing);
            return closing.defaultPrevented;""")


class Drawing(Sketch):
    def test_an_overhand_knot_is_drawn_exchanged_tied_and_saved(self):
        self.draw(OVERHAND)
        self.assertEqual(self.status(), "")
        self.assertEqual(len(self.crossings()), 3)
        self.assertEqual(self.letters(), "OUOUOU")
        self.assertIn("trefoil", self.knot())
        self.picture("drawn")
        self.crossings()[1].click()
        self.wait_for_answer()
        self.assertIn("unknot", self.knot())
        self.assertEqual(self.letters(), "OOOUUU")
        self.picture("exchanged")
        self.crossings()[1].click()
        self.wait_for_answer()
        self.find("mirror").click()
        self.wait_for_answer()
        self.assertEqual(self.letters(), "UOUOUO")
        self.assertIn("trefoil", self.knot())
        self.tie()
        self.assertIn("ended tight", self.status())
        self.picture("tied")
        self.press(Keys.END)
        self.wait_for(lambda: self.find("frame").text.split()[0] == self.find("frame").text.split()[-1],
                      "the last frame did not come")
        self.save("save_recording", "sketch.rbn", into="")
        self.save("save_scene", "sketch.toml", "sketch.svg", into="")
        self.assertIn("sketch.toml, sketch.svg and cylinder.obj into one folder, under these names", self.status())
        self.save("save_object", "cylinder.obj", into="")
        self.save("save_shape", "sketch.obj", "sketch.mtl", into="")
        self.save("save_motion", "sketch.glb", into="")
        self.assertEqual(self.browser.find_errors(), [])

    def test_closing_asks_where_something_is_unsaved(self):
        self.assertFalse(self.would_ask_before_closing())
        self.begin_with("overhand knot")
        self.assertTrue(self.would_ask_before_closing())
        self.tie(frames=5)
        self.stop()
        self.save("save_scene", "sketch.toml", "sketch.svg")
        self.assertTrue(self.would_ask_before_closing())
        self.save("save_recording", "sketch.rbn")
        self.assertFalse(self.would_ask_before_closing())

    def test_looking_for_a_start_is_stopped_and_nothing_is_lost(self):
        self.begin_with("overhand knot")
        self.tie(frames=5)
        self.stop()
        frames = self.script("return recording.frames")
        self.find("draw_mode").click()
        points = self.points()
        self.script("""
            document.getElementById('tie').click();
            if (document.getElementById('stop_looking').hidden) throw new Error('nothing to stop it by');
            document.getElementById('stop_looking').click();""")
        self.assertIn("Stopped", self.status())
        self.assertEqual(self.points(), points)
        self.find("watch_mode").click()
        self.press(Keys.HOME)
        self.wait_for(lambda: self.find("frame").text == f"1 of {frames}", "the recording was lost")
        self.save("save_motion", "sketch.glb")
        self.find("draw_mode").click()
        self.tie(frames=5)

    def test_frames_a_second_are_those_of_tying(self):
        """Not of looking for a start before; and a refusal ends their telling."""
        self.begin_with("overhand knot")
        Select(self.find("mesh")).select_by_index(1)  # not over before it can be stopped
        self.script("""
            const opened = take_opened;
            take_opened = (...given) => { window.opened_ms = performance.now(); opened(...given); };""")
        self.tie(frames=5)
        self.assertGreaterEqual(self.script("return begun_ms - opened_ms"), 0)
        self.assertIn("frames/s", self.find("tying").text)
        told = self.browser.execute_async_script("""
            const done = arguments[0];
            take = () => {};
            take_grown(recording.frames, recording.numbers);
            take_refusal('it goes no further', new Uint8Array(8));
            requestAnimationFrame(() => requestAnimationFrame(() => done(element('tying').textContent)));""")
        self.assertEqual(told, "")
        self.assertEqual(self.status(), "it goes no further")

    def test_it_goes_on_in_the_background(self):
        self.begin_with("overhand knot")
        Select(self.find("mesh")).select_by_index(1)
        self.tie(frames=5)
        self.browser.cover()
        self.assertTrue(self.script("return document.hidden"))
        self.script("window.heard = 0; const heard = take_grown; "
                    "take_grown = (frames, numbers) => { window.heard = frames; heard(frames, numbers); }")
        self.wait_for(lambda: self.script("return heard") >= 30, "it does not go on")
        self.browser.uncover()
        self.wait_for(lambda: self.script("return recording.frames") >= 30, "it is not shown")

    def test_memory_that_runs_out_is_told_and_what_was_tied_is_kept(self):
        self.script("""
            const last = [...document.querySelectorAll('script.of_worker')].at(-1);
            last.textContent += `
              WebAssembly.Memory.prototype.grow = () => { throw new RangeError('there is no more'); };
              const record_some = record_frames;
              let turns = 0;
              record_frames = () => {
                if (++turns === 2) for (let size = 1 << 24; size >= 16; size /= 2) while (library._malloc(size));
                record_some();
              };`;
            end_worker();
            send_object();
            start_worker();""")
        self.begin_with("overhand knot")
        Select(self.find("mesh")).select_by_index(1)
        self.wait_for_answer()
        points = self.points()
        self.find("tie").click()
        self.wait_for(lambda: "could not be computed" in self.status(), "it is not told")
        self.assertIn("memory has run out", self.status())
        self.assertIn("What was tied until then", self.status())
        self.assertEqual(self.points(), points)
        self.assertTrue(self.would_ask_before_closing())
        self.wait_for(lambda: self.script("return !wanted.is_asked && recording.ending === 'unknown'"),
                      "it is not opened again")
        frames = self.script("return recording.frames")
        self.press(Keys.HOME)
        self.wait_for(lambda: self.find("frame").text == f"1 of {frames}", "frame 1 did not come")
        self.press(Keys.END)
        self.wait_for(lambda: self.find("frame").text == f"{frames} of {frames}", "the end did not come")
        self.picture("out-of-memory")
        self.save("save_recording", "sketch.rbn", into="out-of-memory")

    def test_is_usable_within_a_second(self):
        self.check_is_usable_soon()

    def test_points_are_put_dragged_undone_and_redone(self):
        for place in OVERHAND[:6]:
            self.click(place)
        put = self.points()
        self.assertEqual(len(put), 6)
        ActionChains(self.browser).move_to_element_with_offset(
            self.find("paper"), *self.on_screen(put[3])).click_and_hold().move_by_offset(
                30, -20).release().perform()
        self.wait_for_answer()
        moved = self.points()
        self.assertEqual(len(moved), 6)
        self.assertGreater(moved[3][0], put[3][0] + 50)
        self.assertLess(moved[3][1], put[3][1] - 30)
        self.find("undo").click()
        self.assertNotEqual(self.points(), moved)
        self.find("redo").click()
        self.assertEqual(self.points(), moved)
        ActionChains(self.browser).key_down(Keys.CONTROL).send_keys("z").key_up(Keys.CONTROL).perform()
        self.assertNotEqual(self.points(), moved)
        self.find("clear").click()
        self.assertEqual(self.points(), [])
        self.find("undo").click()
        self.assertEqual(len(self.points()), 6)

    def test_a_choice_stays_when_a_point_is_dragged(self):
        self.draw(OVERHAND)
        self.crossings()[0].click()
        self.wait_for_answer()
        letters = self.letters()
        ActionChains(self.browser).move_to_element_with_offset(
            self.find("paper"), *self.on_screen(self.points()[0])).click_and_hold().move_by_offset(
                -10, 15).release().perform()
        self.wait_for_answer()
        self.assertEqual(self.letters(), letters)

    def test_a_choice_stays_where_answers_come_late(self):
        self.draw(OVERHAND)
        self.crossings()[0].click()
        self.wait_for_answer()
        letters = self.letters()
        self.script("board.select(0); for (let i = 0; i < 3; ++i) board.shift(-2, 1)")
        self.wait_for_answer()
        self.assertEqual(self.letters(), letters)
        # The worker answers while a point is being dragged.
        first = self.points()[0]
        self.script("""
            board.pointers.set(1, [0, 0]);
            [board.dragged, board.before] = [0, board.points];
            board.pull({pointerId: 1, clientX: 100, clientY: 100});
            const dragged = board.points[0];
            board.show(states.state.points, states.state.told);
            if (board.points[0] !== dragged) throw new Error('the drag is lost');
            board.lift({pointerId: 1});""")
        self.wait_for_answer()
        self.assertNotEqual(self.points()[0], first)

    def test_keys_move_the_point_that_is_chosen(self):
        for place in ((-700, 100), (-650, 300), (-600, 550)):
            self.click(place)
        before = self.points()
        self.click(before[1])
        self.press(Keys.ARROW_RIGHT)
        x, y = self.points()[1]
        self.assertTrue(before[1][0] < x < before[1][0] + 100, x)
        self.assertEqual(y, before[1][1])
        self.press("N", "N", Keys.DELETE, Keys.ARROW_RIGHT)  # removes the first one, then moves the next
        (second_x, second_y), last = self.points()
        self.assertTrue(x < second_x < x + 100, second_x)
        self.assertEqual(second_y, y)
        self.assertEqual(last, before[2])

    def test_the_object_is_exchanged_under_a_drawing(self):
        choose = Select(self.find("object")).select_by_visible_text

        def passes_of(item):
            choose(item)
            self.wait_for_answer()
            self.assertEqual(self.script("return answer.problem"), "", item)
            return len(self.passes())
        self.draw([(-1100, 160), (1100, 160)])  # over the cylinder, past the box
        self.assertEqual([passes_of(item) for item in ("box", "cylinder", "box")], [0, 1, 0])
        self.find("clear").click()
        self.draw([(-1100, 0), (1100, 0)])  # over both
        self.passes()[0].click()
        self.wait_for_answer()
        self.assertEqual(self.letters(), "B")
        self.assertEqual([passes_of(item) for item in ("cylinder", "box", "cylinder")], [1, 1, 1])
        self.find("undo").click()  # what it was round the box
        self.wait_for_answer()
        self.assertEqual(self.letters(), "F")
        self.assertEqual(self.script("return answer.problem"), "")

    def test_tie_is_pressed_again_at_once(self):
        self.begin_with("overhand knot")
        self.tie(frames=5)
        self.stop()
        tied = self.script("return tied.recording.length")
        self.script("tie(); stop_looking(); tie(); stop_looking();")
        self.wait_for(lambda: self.script("return worker !== null && !wanted.is_asked"), "there is no worker")
        self.assertEqual(self.script("return tied.recording.length"), tied)
        self.script("tie()")
        self.wait_for(lambda: self.script("return most_frames > 0 && is_tying && begun === null"), "it does not tie")
        self.stop()
        self.assertGreater(self.script("return tied.recording.length"), 0)
        self.assertEqual(self.browser.find_errors(), [])
        # The worker knows the object.
        self.find("draw_mode").click()
        self.find("clear").click()
        self.assertFalse(self.script("return unsaved.drawing"))
        self.find("undo").click()
        self.assertTrue(self.script("return unsaved.drawing"))
        self.find("clear").click()
        self.draw([(-1100, 0), (1100, 0)])
        self.assertEqual(len(self.passes()), 1)

    def test_keys_draw_exchange_and_tie(self):
        self.script("document.getElementById('board').focus()")
        self.press(*40 * [Keys.ARROW_DOWN])  # out of the object
        self.press(Keys.ENTER, Keys.ARROW_RIGHT, Keys.ARROW_RIGHT, Keys.ENTER, Keys.ARROW_DOWN, Keys.ENTER)
        self.assertEqual(len(self.points()), 3)
        self.assertIn("Point 3", self.status())
        self.press("p", Keys.ARROW_UP)
        self.assertIn("Point 3 of 3", self.status())
        self.press(Keys.DELETE)
        self.assertEqual(len(self.points()), 2)
        self.begin_with("overhand knot")
        self.wait_for(lambda: len(self.crossings()) > 0, "no crossings")
        self.crossings()[0].send_keys(Keys.ENTER)
        self.wait_for(lambda: "Crossing 1 of " in self.status(), "it is not told")
        self.wait_for_answer()
        self.assertIn("first under", self.crossings()[0].get_attribute("aria-label"))

    def test_it_is_chosen_what_passes_in_front_of_the_object_and_what_behind(self):
        self.draw([(-800, 0), (800, 0), (800, 500), (100, 500), (100, -600)])
        self.assertEqual(self.letters(), "FOFU")
        self.assertIn("in front, then in front", self.status())
        self.passes()[0].click()
        self.wait_for_answer()
        self.assertEqual(self.letters(), "BOFU")
        self.assertIn("Passage 1 of 2: the curve runs behind the object", self.status())
        self.assertEqual(self.passes()[0].text, "B")
        self.passes()[1].send_keys(Keys.ENTER)
        self.wait_for(lambda: self.letters() == "BOBU", "the key does not exchange")
        self.assertIn("behind the object", self.passes()[1].get_attribute("aria-label"))
        self.find("undo").click()
        self.wait_for_answer()
        self.assertEqual(self.letters(), "BOFU")
        self.find("redo").click()
        self.find("undo").click()
        self.wait_for_answer()
        ActionChains(self.browser).move_to_element_with_offset(
            self.find("paper"), *self.on_screen(self.points()[1])).click_and_hold().move_by_offset(
                10, 10).release().perform()
        self.wait_for_answer()
        self.assertEqual(self.letters(), "BOFU")
        self.assertTrue(self.script("return board.band_behind.getAttribute('d')"))
        self.check_controls()
        self.picture("passes")
        self.find("clear").click()
        self.draw([(-1100, 0), (1100, 0)])  # long enough to rise over the object's edge
        self.passes()[0].click()
        self.wait_for_answer()
        self.tie(frames=5)
        self.stop()
        self.picture("behind")
        self.save("save_recording", "sketch.rbn", into="behind")
        self.save("save_scene", "sketch.toml", "sketch.svg", into="behind")
        self.save("save_object", "cylinder.obj", into="behind")
        self.assertIn('crossings = "B"', (FOLDER / "behind" / "sketch.toml").read_text())

    def test_no_button_lies_on_another(self):
        """Crossings right at the object's outline, and two of them close together."""
        self.draw([(-800, 0), (800, 0), (800, 500), (250, 500), (250, -600)])
        left = min(place["at"][0] for place in self.script("return states.state.told.passes"))
        self.find("clear").click()
        self.draw([(-800, 0), (800, 0), (800, 500), (left, 500), (left, -600)])
        self.assertGreater(len(self.crossings()), 0)
        self.assertGreater(len(self.passes()), 0)
        self.check_buttons_lie_apart()
        self.picture("close-buttons")
        self.find("clear").click()
        self.draw([(-700, 500), (700, 500), (700, 560), (0, 560), (0, 400), (60, 400), (60, 620)])
        self.assertGreaterEqual(len(self.crossings()), 3)
        self.check_buttons_lie_apart()
        first = self.letters()
        self.crossings()[1].click()
        self.wait_for_answer()
        self.assertNotEqual(self.letters(), first)

    def check_buttons_lie_apart(self):
        boxes = [button.rect for button in [*self.crossings(), *self.passes()]]
        for i, a in enumerate(boxes):
            for b in boxes[:i]:
                apart = max(abs(a["x"] - b["x"]), abs(a["y"] - b["y"]))
                self.assertGreaterEqual(apart, 43.5)

    def test_mistakes_are_told_at_their_place(self):
        self.draw([(-800, 0), (0, 0)])
        self.assertIn("an end of the curve lies in front of the object", self.status())
        self.assertTrue(self.find("mistake").is_displayed())
        self.picture("mistake")
        self.find("clear").click()
        self.assertFalse(self.find("mistake").is_displayed())
        for place in ((-500, 400), (500, 400), (500, 600), (0, 400), (-500, 600)):
            self.click(place)
        self.assertRegex(self.status(), r"\(-?[01](\.\d+)?, (39[5-9]|40[0-5])")
        self.find("tie").click()
        self.wait_for(lambda: not self.status().startswith("Looking"), "Tie is not answered")
        self.assertRegex(self.status(), r"\(-?[01](\.\d+)?, (39[5-9]|40[0-5])")
        self.assertEqual(self.script("return document.body.dataset.mode"), "draw")

    def test_a_scribble_is_told_at_its_place_and_stays(self):
        # Four times round the object, across itself each time, some of it twice.
        reaches = [380 + 220 * math.sin(2.3 * k) for k in range(28)]
        scribble = [(reach * math.cos(0.9 * k), reach * math.sin(0.9 * k)) for k, reach in enumerate(reaches)]
        scribble += [*scribble[3:8], (640, 420)]
        self.draw(scribble)
        sentence = r"^drawing at \(.*\): (two pieces|three pieces|an end) of the curve .*; "
        self.assertRegex(self.status(), sentence)
        self.assertTrue(self.find("mistake").is_displayed())
        points = self.points()
        self.find("tie").click()
        self.wait_for(lambda: not self.status().startswith("Looking"), "Tie is not answered")
        self.assertRegex(self.status(), sentence)
        self.picture("scribble")
        self.assertEqual(self.script("return document.body.dataset.mode"), "draw")
        self.assertEqual(self.points(), points)
        self.find("undo").click()
        self.assertEqual(self.points(), [])
        self.begin_with("overhand knot")
        self.assertIn("trefoil", self.knot())
        self.assertEqual(self.browser.find_errors(), [])

    def test_ready_knots_go_round_every_object(self):
        for item in ("cylinder", "hourglass", "neck", "box"):
            Select(self.find("object")).select_by_visible_text(item)
            for knot, name in (("overhand knot", "trefoil"), ("figure eight knot", "figure-eight"),
                               ("cinquefoil knot", "cinquefoil")):
                self.begin_with(knot)
                self.assertIn(name, self.knot(), item)
                self.assertEqual(self.status(), "", item)
            self.picture(f"round-{item}")

    def test_it_is_stopped_scrubbed_and_tied_anew(self):
        self.begin_with("overhand knot")
        Select(self.find("mesh")).select_by_index(1)  # not over before it can be stopped
        self.tie(frames=5)
        self.find("stop").click()
        self.wait_for(lambda: "ended early" in self.status(), "it does not stop")
        frames = self.script("return recording.frames")
        self.press(Keys.HOME)
        self.wait_for(lambda: self.find("frame").text.startswith("1 of"), "frame 1 did not come")
        self.press(Keys.END)
        self.wait_for(lambda: self.find("frame").text == f"{frames} of {frames}", "the end did not come")
        self.find("draw_mode").click()
        self.tie(frames=20)
        self.find("draw_mode").click()
        self.find("clear").click()
        self.find("watch_mode").click()
        self.wait_for(lambda: self.script("return recording.frames") >= 40, "it does not go on")

    def all_is_seen(self):
        """Of the last frame and its object; None while it is not shown."""
        is_shown = self.script(
            "return view.particles && timeline.index === recording.frames - 1 && !wanted.is_asked")
        return self.lies_in_picture("view.particles", 7) and self.lies_in_picture(
            "recording.obstacle", 6) if is_shown else None

    def test_all_is_seen_until_who_watches_turns_the_picture(self):
        self.begin_with("overhand knot")
        self.tie()
        self.press(Keys.END)
        self.wait_for(lambda: self.all_is_seen() is not None, "the last frame did not come")
        self.assertTrue(self.all_is_seen(), "pulled out of the picture")
        self.browser.set_screen(390, 844)
        self.wait_for(lambda: self.script("return stage.clientWidth <= 390"), "the screen stays wide")
        self.wait_for(lambda: self.all_is_seen(), "not all is seen on a phone")
        self.script("turn(0.5, 0); zoom(3)")
        camera = "const {azimuth, distance, middle} = view.camera; return [azimuth, distance, ...middle]"
        moved = self.script(camera)
        self.press(Keys.HOME)
        self.wait_for(lambda: self.find("frame").text.startswith("1 of"), "frame 1 did not come")
        self.find("draw_mode").click()
        self.script("document.getElementById('tie').click(); document.getElementById('stop_looking').click()")
        self.wait_for(lambda: self.script("return worker !== null && !wanted.is_asked"), "it is not opened again")
        self.find("watch_mode").click()
        self.assertEqual(self.script(camera), moved)
        self.find("draw_mode").click()
        Select(self.find("object")).select_by_visible_text("box")
        self.begin_with("figure eight knot")
        self.tie(frames=30)
        self.stop()
        self.press(Keys.END)
        self.wait_for(lambda: self.all_is_seen(), "another knot is not framed anew")
        self.picture("framed-on-a-phone")

    def test_loads_nothing_from_anywhere(self):
        self.assertEqual(self.asked_of_others(), [])
        self.assertEqual(self.blocked_by_policy(), "connect-src")

    def test_worker_that_falls_is_replaced_and_the_drawing_stays(self):
        self.begin_with("overhand knot")
        points = self.points()
        self.script("take({broken: 'out of memory'})")
        self.assertIn("out of memory", self.status())
        self.assertEqual(self.points(), points)
        self.tie(frames=5)

    def test_every_control_has_a_name_and_room_for_a_finger(self):
        self.begin_with("overhand knot")
        self.check_controls()
        Select(self.find("mesh")).select_by_index(1)  # still tied while its controls are looked at
        self.tie(frames=5)
        self.check_controls()
        self.stop()
        self.check_controls()

    def test_fits_a_phone_while_one_draws_ties_and_watches(self):
        self.browser.set_screen(390, 844)
        self.wait_for(lambda: self.script("return innerWidth === 390"), "the screen stays wide")
        self.begin_with("overhand knot")
        self.check_fits_a_phone()
        Select(self.find("mesh")).select_by_index(1)  # still tied while it is looked at
        self.tie(frames=5)
        self.check_fits_a_phone()
        self.stop()
        self.check_fits_a_phone()
        self.picture("phone-watch")
        distance = self.script("return view.camera.distance")
        x, y, width, height = self.script(
            "const b = stage.getBoundingClientRect(); return [b.left, b.top, b.width, b.height]")
        middle = y + height / 2
        self.touch([(x + width / 2 - 20 - 10 * step, middle) for step in range(6)],
                   [(x + width / 2 + 20 + 10 * step, middle) for step in range(6)])
        self.assertLess(self.script("return view.camera.distance"), 0.6 * distance)
        azimuth = self.script("return view.camera.azimuth")
        self.touch([(x + 100 + 10 * step, middle) for step in range(6)])
        self.assertNotAlmostEqual(self.script("return view.camera.azimuth"), azimuth, delta=0.1)

    def test_tie_is_within_reach_on_a_phone(self):
        """Also where the browser's own bars take a fifth of the screen."""
        self.browser.set_screen(390, 664)
        self.wait_for(lambda: self.script("return innerWidth === 390"), "the screen stays wide")
        self.begin_with("overhand knot")
        self.assertLessEqual(self.script("return element('tie').getBoundingClientRect().bottom"), 664)
        self.assertEqual(self.script("return scrollY"), 0)

    def test_the_picture_has_the_room(self):
        sizes = ((1200, 800), (1366, 768), (844, 390))
        self.begin_with("overhand knot")
        for width, height in sizes:
            self.check_picture_has_the_room(width, height)
            self.picture(f"draw-{width}")
        Select(self.find("mesh")).select_by_index(1)  # still tied while it is looked at
        self.tie(frames=5)
        for width, height in sizes:
            self.check_picture_has_the_room(width, height)
            self.picture(f"tying-{width}")
        self.stop()
        for width, height in sizes:
            self.check_picture_has_the_room(width, height)
            self.picture(f"watch-{width}")

    def test_one_finger_draws_two_zoom(self):
        self.browser.set_screen(390, 844)
        self.wait_for(lambda: self.script("return innerWidth === 390 && board.board.clientWidth <= 390"),
                      "the screen stays wide")
        self.script("fit_board()")
        left, top = self.script("const b = board.board.getBoundingClientRect(); return [b.left, b.top]")

        def at(place):
            x, y = self.script("return board.to_screen(arguments[0])", list(place))
            return left + x, top + y
        self.touch([at(place) for place in OVERHAND])
        self.wait_for_answer()
        self.assertGreater(len(self.points()), 10)
        self.assertLessEqual(self.script("return document.documentElement.scrollWidth"), 390)
        self.assertGreater(self.script("return board.board.clientHeight"), 250)
        self.picture("phone-sketch")
        points = self.points()
        for _ in range(4):  # the fingers are lifted in motion; what is tapped at once must answer
            scale = self.script("return board.scale")
            self.touch([(150 - 10 * step, 300) for step in range(6)], [(250 + 10 * step, 300) for step in range(6)])
            self.assertAlmostEqual(self.script("return board.scale") / scale, 2, delta=0.3)
            self.assertEqual(self.points(), points)
            self.script("board.zoom(3, [40, 30])")
            self.assertFalse(self.drawing_is_seen())
            left, top, width, height = self.script(
                "const b = all_seen.getBoundingClientRect(); return [b.left, b.top, b.width, b.height]")
            self.touch([(left + width / 2, top + height / 2)])
            self.wait_for(self.drawing_is_seen, "Show all shows a part")
        self.picture("phone-all-seen")
        self.assertTrue(self.script("return all_seen.hidden"))
        self.assertEqual(self.points(), points)

    def turn_phone(self, width, height):
        self.browser.set_screen(width, height)
        self.wait_for(lambda: self.script(
            "return innerWidth === arguments[0] && board.board.clientWidth <= innerWidth", width),
                      "the screen is not turned")

    def drawing_is_seen(self):
        """Each point and the whole object lie on the board."""
        return self.script("""
            const corners = board.shape.getBBox();
            const places = [...board.points, [corners.x, corners.y],
                            [corners.x + corners.width, corners.y + corners.height]];
            const {clientWidth, clientHeight} = board.board;
            return places.map(place => board.to_screen(place)).every(
                ([x, y]) => x >= 0 && y >= 0 && x <= clientWidth && y <= clientHeight);""")

    def share_of_board(self):
        """Of the drawing, in the direction in which it fills more."""
        return self.script("""
            const xs = board.points.map(([x]) => x), ys = board.points.map(([, y]) => y);
            const {clientWidth, clientHeight} = board.board;
            return board.scale * Math.max((Math.max(...xs) - Math.min(...xs)) / clientWidth,
                                          (Math.max(...ys) - Math.min(...ys)) / clientHeight);""")

    def test_an_object_that_comes_while_one_draws_is_framed_with_the_stroke(self):
        view = "return [board.scale, ...board.middle]"
        before = self.script(view)
        self.script("""
            delete board.box;
            board.pointers.set(1, [0, 0]);
            [board.stroke, board.way_px] = [[[-3000, 900], [3000, 900]], 100];
            choose_object(1);""")
        self.wait_for(lambda: not self.script("return is_new_object"), "the object did not come")
        self.assertEqual(self.script(view), before)
        self.script("board.lift({pointerId: 1})")
        self.assertEqual(len(self.points()), 2)
        self.assertTrue(self.drawing_is_seen())
        self.script("board.zoom(3, [40, 30]); all_seen.click()")
        self.assertTrue(self.drawing_is_seen())

    def test_the_drawing_fits_a_phone_that_is_turned(self):
        self.turn_phone(390, 844)
        self.begin_with("overhand knot")
        for width, height in ((844, 390), (390, 844)):
            self.turn_phone(width, height)
            self.wait_for(lambda: self.drawing_is_seen() and self.share_of_board() > 0.5,
                          "the drawing is cut off or small")
            self.picture(f"board-{width}")
        self.script("board.zoom(3, [40, 30])")
        view = "return [board.scale, ...board.middle]"
        zoomed = self.script(view)
        self.turn_phone(844, 390)
        self.wait_for(lambda: self.script("return Number(paper.getAttribute('viewBox').split(' ')[2]) === "
                                          "board.board.clientWidth / board.scale"), "it is not drawn anew")
        self.assertEqual(self.script(view), zoomed)
        self.script("board.board.focus()")
        self.press("0")
        self.assertTrue(self.drawing_is_seen())
        self.turn_phone(390, 844)
        self.wait_for(lambda: self.drawing_is_seen(), "the drawing is cut off once more")


class DarkSketch(Sketch):
    dark = True

    def test_has_a_dark_face(self):
        self.begin_with("figure eight knot")
        self.picture("dark-sketch")
        paper = self.script("return getComputedStyle(document.body).backgroundColor")
        self.assertEqual(paper, "rgb(29, 31, 34)")


class OwnScene(Sketch):
    """A page that was written for a scene."""

    page = PAGES / "own.html"

    def test_its_drawing_is_offered_and_tied_as_it_stands_there(self):
        self.assertFalse(self.find("object").is_displayed())
        self.begin_with("its own drawing")
        self.assertIn("trefoil", self.knot())
        self.tie(frames=5)
        self.assertEqual(self.script("return [recording.along, recording.across]"), [100, 4])
        self.assertFalse(self.find("save_object").is_displayed())
        self.stop()
        self.save("save_scene", "overhand-cylinder-8x400-sketch.toml", "sketch.svg")
        self.assertIn("8x400-sketch.toml and sketch.svg into the folder of overhand-cylinder-8x400.toml, under these",
                      self.status())

    def test_its_width_stays_as_it_was_written_until_another_is_chosen(self):
        of_width = "scene.width_m = arguments[0]; choose_object(0); return [element('width').value, settings()]"
        for width_m, seen in ((0.06, "6"), (0.009525, "0.9525"), (0.014, "1.4"), (0.1 / 3, "3.33333333333")):
            self.assertEqual(self.script(of_width, width_m), [seen, ""], width_m)
        self.script("element('width').value = '1.4'")
        self.assertEqual(self.script("return settings()"), "ribbon.width=0.014")


class OwnReef(Sketch):
    """Over and under do not take turns."""

    page = PAGES / "reef.html"

    def test_its_drawing_ties_what_its_scene_ties(self):
        self.begin_with("its own drawing")
        self.assertEqual(self.letters(), "OUOOUOUOUUOU")
        self.assertIn("reef knot", self.knot())


class InMetres(Sketch):
    """A drawing unit is a metre."""

    page = PAGES / "metres.html"

    def test_it_is_drawn_as_finely_as_in_millimetres(self):
        self.begin_with("its own drawing")
        self.assertGreater(len(self.points()), 15)
        self.assertIn("trefoil", self.knot())
        scale = self.script("return board.scale")
        self.script("board.zoom(1.2, [40, 30])")
        self.assertAlmostEqual(self.script("return board.scale") / scale, 1.2)
        self.crossings()[1].click()
        self.wait_for_answer()
        letters = self.letters()
        said = self.script("board.select(0); board.shift(-0.02, 0.01); return status_line.textContent")
        x, y = self.points()[0]
        self.assertRegex(said, rf"^Point 1 of \d+: {round(x, 3):g}, {round(y, 3):g}$")
        self.wait_for_answer()
        self.assertEqual(self.letters(), letters)


class WithoutPicture(Sketch):
    with_picture = False

    def test_knots_are_tied_all_the_same(self):
        self.begin_with("overhand knot")
        self.tie(frames=5)
        self.assertTrue(self.find("no_picture").is_displayed())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
