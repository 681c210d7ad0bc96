// Faces that failed: why, and where their fronts got stuck.

function stuckLines(mesh, faces) {
  return faces.flatMap((face) => (face.stuck ?? []).flatMap(({ from, to }) =>
    [from, to].flatMap((point) => point.map((x, axis) => x - mesh.centre[axis]))));
}

/** Each stuck edge, with the reasons why rules were refused there. */
function stuckEdges(mesh, view, face) {
  if (!face.stuck.length) return null;
  const rows = face.stuck.map((stuck) => node("li", {},
    node("button", { type: "button", onclick: () => zoomToLines(view, stuckLines(mesh, [{ stuck: [stuck] }]), 4) },
      `(${stuck.from.map(digits).join(", ")})`),
    ` level ${stuck.level}`,
    node("ul", {}, ...stuck.refused.map(([rule, reason]) => node("li", {}, `${ruleTitle(mesh, rule)}: ${reason}`)))));
  return node("details", {}, node("summary", {}, "Why no rule was accepted there"), node("ul", {}, ...rows));
}

function attempts(face) {
  if (!face.attempts?.length) return null;
  return node("details", {}, node("summary", {}, counted(face.attempts.length, "attempt")),
    node("ul", {}, ...face.attempts.map((text) => node("li", {}, text))));
}

function failedRow(mesh, view, face) {
  const ends = stuckLines(mesh, [face]);
  const show = (event) => {
    for (const button of document.querySelectorAll("#failed-list > li > button")) button.ariaPressed = "false";
    event.currentTarget.ariaPressed = "true";
    zoomToLines(view, ends, 4);
  };
  const title = face.status === "failed" ? faceTitle(face) : `${faceTitle(face)} (${face.status})`;
  const heading = ends.length > 0
    ? node("button", { type: "button", "aria-pressed": "false", onclick: show, title: "Zoom to where its front got stuck" }, title)
    : node("strong", {}, title);
  return node("li", {}, heading, node("p", {}, face.reason || "no reason given"),
    ends.length > 0 ? node("p", { class: "muted" }, `${counted(face.stuck.length, "stuck edge")} drawn in red`) : null,
    stuckEdges(mesh, view, face), attempts(face));
}

/** Lists failed faces and draws their stuck edges. */
function showFailures(mesh, view) {
  const failed = mesh.faces.filter((face) => face.status === "failed" || face.status === "cancelled");
  document.getElementById("failed").hidden = failed.length === 0;
  document.getElementById("failed-title").textContent =
    `${counted(failed.length, "face")} of ${mesh.faces.length} without a mesh`;
  document.getElementById("failed-list").replaceChildren(
    ...failed.slice(0, mostRows).map((face) => failedRow(mesh, view, face)));
  setMarkerLines(view.stuck, stuckLines(mesh, failed));
}
