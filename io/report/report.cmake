# Puts the files of a report's page into the library brachium_io. uPlot comes from npm, in the version that
# package-lock.json holds with its checksum; without npm, or where it cannot be fetched, reports show pictures only.
option(BRACHIUM_UPLOT "Fetch uPlot with npm, for live charts in reports" ON)

set(page ${CMAKE_CURRENT_LIST_DIR})
set(uplot "")
find_program(BRACHIUM_NPM npm)
if(BRACHIUM_UPLOT AND BRACHIUM_NPM)
  set(vendor ${CMAKE_BINARY_DIR}/uplot)
  set(uplot ${vendor}/node_modules/uplot)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${page}/package-lock.json)
  if(${page}/package-lock.json IS_NEWER_THAN ${uplot}/LICENSE)
    file(COPY ${page}/package.json ${page}/package-lock.json DESTINATION ${vendor})
    execute_process(COMMAND ${BRACHIUM_NPM} ci --ignore-scripts --no-audit --no-fund --fetch-retries=1
      WORKING_DIRECTORY ${vendor} TIMEOUT 120 RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
    if(NOT failed)
      file(TOUCH ${uplot}/LICENSE)
    endif()
  endif()
  if(NOT EXISTS ${uplot}/dist/uPlot.iife.min.js)
    set(uplot "")
  endif()
endif()
if(uplot)
  message(STATUS "Reports: live charts by uPlot")
else()
  message(STATUS "Reports: pictures only, uPlot is not there")
endif()

set(page_sources ${page}/page.css ${page}/packed.js ${page}/charts.js ${page}/scene.js ${page}/replay.js ${page}/embed.cmake)
set(embedded ${CMAKE_BINARY_DIR}/generated/page_files$<$<BOOL:${uplot}>:_uplot>.cc)
add_custom_command(OUTPUT ${embedded}
  COMMAND ${CMAKE_COMMAND} -DOUTPUT=${embedded} -DPAGE=${page} -DUPLOT=${uplot} -P ${page}/embed.cmake
  DEPENDS ${page_sources} VERBATIM)
target_sources(brachium_io PRIVATE ${embedded})
