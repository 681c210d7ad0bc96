// What the page plays: events one after the other, and the elements that each of them made or removed.

const eventKinds = { refused: 0, applied: 1, closed: 2, turned: 3, row: 4, firstAct: 5 };

/** The run: arrays by event and by element, and the mesh of all elements that existed at some time. */
function readRun() {
  const run = JSON.parse(document.getElementById("info").textContent);
  for (const name of ["kind", "level", "rule", "front", "chart", "from", "to", "before", "after", "birth", "death", "moves", "moved", "moveCount"])
    run[name] = readArray(name);
  run.eventCount = run.kind.length;
  const corners = readArray("corners"), elementCount = run.birth.length;
  const positions = readArray("positions");
  run.mesh = {
    positions, corners, elementCount, cornersPerElement: 4, centre: run.centre, faces: [], middles: null,
    vertexCount: positions.length / 3, face: new Uint8Array(elementCount),
  };
  run.charts = document.getElementById("charts").textContent.split("\n");
  numberSteps(run);
  run.deaths = Array.from(run.death.keys()).filter((e) => run.death[e] < run.eventCount)
    .sort((a, b) => run.death[a] - run.death[b]);
  return run;
}

function isStep(run, event) {
  return run.kind[event] <= eventKinds.applied;
}

/** Steps, and the smoothing of rows between them. */
function isOfFront(run, event) {
  return isStep(run, event) || run.kind[event] === eventKinds.row;
}

/** By event: its face, the number of the last step in the face, and the first of its moves. */
function numberSteps(run) {
  run.step = new Uint32Array(run.eventCount);
  run.faceOf = new Uint16Array(run.eventCount);
  run.firstMove = new Uint32Array(run.eventCount);
  let moves = 0, step = 0, face = 0;
  for (let event = 0; event < run.eventCount; ++event) {
    while (face + 1 < run.faces.length && run.faces[face + 1].firstEvent <= event) {
      ++face;
      step = 0;
    }
    if (isStep(run, event)) ++step;
    run.step[event] = step;
    run.faceOf[event] = face;
    run.firstMove[event] = moves;
    moves += run.moveCount[event];
  }
  run.firstEvent = 0;
  run.lastEvent = Math.max(0, run.eventCount - 1);
  if (run.firstStep > 1) run.firstEvent = eventOfStep(run, 0, run.firstStep);
  if (run.lastStep > 0) run.lastEvent = eventOfStep(run, 0, run.lastStep);
}

/** The event of a step of a face, by the index of the face; -1: there is none. */
function eventOfStep(run, face, step) {
  for (let event = run.faces[face].firstEvent; event < run.eventCount && run.faceOf[event] === face; ++event)
    if (run.step[event] === step && isStep(run, event)) return event;
  return -1;
}

/** The chart of a step, or null if the page has none. */
function chartOf(run, event) {
  return run.chart[event] < 0 ? null : JSON.parse(run.charts[run.chart[event]]);
}

/** The first element in an ascending list that is not below a value. */
function lowerBound(list, value, of) {
  let low = 0, high = list.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (of(list[middle]) < value) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** The elements that an event made; they are numbered in the order of time. */
function bornAt(run, event) {
  const found = [];
  let element = lowerBound(run.birth, event, (birth) => birth);
  for (; element < run.birth.length && run.birth[element] === event; ++element) found.push(element);
  return found;
}

function diedAt(run, event) {
  const found = [];
  for (let i = lowerBound(run.deaths, event, (e) => run.death[e]); i < run.deaths.length; ++i) {
    if (run.death[run.deaths[i]] !== event) break;
    found.push(run.deaths[i]);
  }
  return found;
}

/** The name that the table and the chart give each vertex: a and b for the base edge, then p1, p2, ... */
function vertexNames(chart) {
  const names = new Array(chart.v.length).fill("");
  names[chart.b[0]] = "a";
  names[chart.b[1]] = "b";
  let number = 0;
  for (const v of [...chart.c.flat(), ...chart.i]) names[v] ||= `p${++number}`;
  return names;
}

/** One rule of a chart with names for its parts. */
function candidatesOf(chart) {
  return chart.r.map(([rule, reason, matches, score, matched = [], zones = [], made = [], cause = null, hit = []]) =>
    ({ rule, reason, matches, score, matched, zones, made, cause, hit }));
}
