// The page that plays: a recording comes from the page itself or is dropped on it.
'use strict';

let source = null;      // the file that is shown, for a worker that has to begin anew
const asked_for = [];   // the files that the worker is to open, and whether they are the one that is shown
let last_choice = 0;    // the number of the last file that was to be opened

function take(answer) {
  if (answer.opened) take_recording(answer.opened, asked_for.shift());
  else if (answer.refused) tell_refusal(answer.refused);
  else if (answer.broken) take_over(answer.broken);
  else take_frame(answer);
}

function tell_refusal(sentence) {
  asked_for.shift();
  tell_problem(sentence);
}

// Out of memory, most likely. What was shown is opened again; what could not be opened is not.
let last_fall_ms = -Infinity;
async function take_over(reason) {
  end_worker();
  asked_for.length = 0;
  wanted.buffer = null;
  const falls_again = performance.now() - last_fall_ms < 5000;
  last_fall_ms = performance.now();
  tell_problem(`the file could not be decoded (${reason}); ` +
               (falls_again ? 'reload the page' : 'it may be too large for this browser'));
  if (falls_again) return;
  const choice = last_choice;
  await start_worker();
  if (source && choice === last_choice) open_file(source, true);
}

// The last one that was chosen, whichever is read first.
async function open_file(file, is_shown = false) {
  const choice = ++last_choice;
  try {
    const bytes = await file.arrayBuffer();
    if (choice !== last_choice) return;
    if (bytes.byteLength === 0) return tell_problem(`${file.name}: is empty; choose a recording (.rbn)`);
    asked_for.push({file, is_shown});
    send({open: bytes, name: file.name}, [bytes]);
  } catch (error) {
    tell_problem(`${file.name}: cannot be read (${error.message}); choose a recording (.rbn)`);
  }
}

function take_recording(opened, {file, is_shown}) {
  wanted.is_asked = false;
  if (is_shown) {
    recording.opening = opened.opening;
    return want(timeline.index);
  }
  show_recording(opened);
  source = file;
  document.title = `${recording.name} – ribbon`;
  element('name').textContent = recording.name;
  element('facts').textContent =
      `${recording.across} × ${recording.along} particles, ${recording.frames} frames, ` +
      `${(recording.length_m * 100).toFixed(0)} × ${(recording.width_m * 100).toFixed(1)} cm`;
  if (!prefers_calm.matches) timeline.start();
  tell_opened();
}

function tell_opened() {
  const {damage} = recording;
  if (damage.length > 0)
    tell_problem(`${source.name} is damaged; what can be read is shown. ${damage[0]}`);
  else tell('');
}

// ---- Files

addEventListener('dragover', event => event.preventDefault());
addEventListener('drop', event => {
  event.preventDefault();
  const file = event.dataTransfer.files[0];
  if (file) open_file(file);
});
element('open').addEventListener('click', () => element('file').click());
element('file').addEventListener('change', event => {
  const file = event.target.files[0];
  if (file) open_file(file);
  event.target.value = '';
});

async function begin() {
  start_view();
  await start_worker();
  const packed = element('recording');
  await open_file(new File([unpacked_base64('recording')], packed.dataset.name));
  packed.textContent = '';  // the file has it now
}

begin().catch(error => tell_problem(`this browser cannot play recordings (${error.message})`));
