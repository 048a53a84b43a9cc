#include "io/report/replay_section.h"

#include "io/report/html.h"

namespace brachium {
namespace {

std::string Choice(const Report& report) {
  std::string html = "<label>Estimate <select class=\"which\">";
  for (std::size_t e = 0; e < report.estimates.size(); ++e)
    html += "<option value=\"" + std::to_string(e) + "\">" + EscapedHtml(report.estimates[e].name) +
            "</option>";
  return html + "</select></label>\n";
}

}  // namespace

std::string ReplaySection(const Report& report) {
  if (report.estimates.empty()) return "";
  return "<section id=\"replay\" tabindex=\"-1\" aria-label=\"Replay\">\n<h2>Replay</h2>\n"
         "<div class=\"controls\">\n" +
         Choice(report) +
         R"(<label><input type="checkbox" class="with-reference" checked> <span class="keys-reference">reference</span></label>
<label><input type="checkbox" class="with-deviation" checked> <span class="keys-deviation">95 % of the last joint's place</span></label>
<span class="keys-estimate">estimate, volar side pale</span>
</div>
<div class="stage">
<canvas class="scene" tabindex="0" role="img" aria-label="The arm in space. Drag or the keys a and d, up and down turn it, plus and minus zoom."></canvas>
<table class="readout"><caption>Angles at this instant [deg]</caption>
<thead><tr><th scope="col"></th><th scope="col">estimate</th><th scope="col">sd</th><th scope="col">reference</th></tr></thead>
<tbody></tbody></table>
</div>
<div class="controls">
<button type="button" class="play">Play</button>
<input type="range" class="time" min="0" max="0" value="0" aria-label="Time">
<span class="clock">0.000 s</span>
<label>Speed <select class="speed"><option value="0.25">¼</option><option value="0.5">½</option><option value="1" selected>1</option><option value="2">2</option><option value="5">5</option><option value="20">20</option></select></label>
</div>
<p class="small hint">Space plays and pauses, left and right step (with shift by a second), Home and End jump; drag the arm or press a, d, up, down to turn it, plus and minus to zoom. A click in a chart below comes here with its time.</p>
<p class="small notes"></p>
</section>
)";
}

}  // namespace brachium
