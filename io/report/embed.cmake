# cmake -DOUTPUT=FILE -DPAGE=DIR -DUPLOT=DIR -P embed.cmake: the files of a report's page as C++, from io/report and,
# unless UPLOT is empty, from an unpacked uPlot.
function(append variable file)
  set(text "")
  if(EXISTS "${file}")
    file(READ "${file}" text)
  endif()
  set(source "${source}constexpr std::string_view ${variable} = R\"page(${text})page\";\n" PARENT_SCOPE)
endfunction()

set(source "// Made by io/report/embed.cmake.\n#include \"io/report/page_files.h\"\n\n")
string(APPEND source "namespace brachium {\nnamespace {\n\n")
append(kStyle "${PAGE}/page.css")
append(kPacked "${PAGE}/packed.js")
append(kCharts "${PAGE}/charts.js")
append(kScene "${PAGE}/scene.js")
append(kReplay "${PAGE}/replay.js")
append(kPlotStyle "${UPLOT}/dist/uPlot.min.css")
append(kPlotScript "${UPLOT}/dist/uPlot.iife.min.js")
append(kPlotLicence "${UPLOT}/LICENSE")
string(APPEND source "\n}  // namespace\n\nPageFiles EmbeddedPageFiles() {\n"
  "  return {kStyle, kPacked, kCharts, kScene, kReplay, kPlotStyle, kPlotScript, kPlotLicence};\n}\n\n}  // namespace brachium\n")
file(WRITE "${OUTPUT}" "${source}")
