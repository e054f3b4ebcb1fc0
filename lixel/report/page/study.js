// What a study found: how error falls with lixels, a chart for each scene, on its planes and off them; or lookups (lookups.js).

const study = run.study;

function showStudy() {
  byId("study").hidden = !study;
  if (!study) return;
  byId("study-title").textContent = study.name;
  byId("study-note").textContent = study.question
    + (study.left_out ? ` Without ${study.left_out} views and lights that some technique refused.` : "");
  if (study.lookups) showLookups();
  else showBudgets();
}

function showBudgets() {
  const techniques = [...new Set(study.curves.map(curve => curve.technique.replace(/planes\([^)]*\)/, "planes")))];
  const lookOf = curve => lineLook(techniques.indexOf(curve.technique.replace(/planes\([^)]*\)/, "planes")));
  byId("study-keys").replaceChildren(
    ...techniques.map((technique, index) => colourKey(technique, lineLook(index).colour)));
  byId("curves").replaceChildren(...[...groupBy(study.curves, curve => curve.scene)].flatMap(([scene, curves]) =>
    [["planes", "on its planes"], ["others", "elsewhere"]].map(([receivers, where]) => {
      const drawn = curves.filter(curve => curve.receivers === receivers);
      return logPlot(`${scene}, ${where}: misclassified %`, drawn.map(curve => ({
        label: curve.technique, ...lookOf(curve),
        points: curve.points.map(point => ({x: point.lixels_used, y: point.misclassified_percent ?? 0,
          title: `${curve.technique}, ${countText(point.lixels_used)} lixels: `
            + `${percentText(point.misclassified_percent)} %`})),
      })), {xTicks: squareTicks});
    })));
}
