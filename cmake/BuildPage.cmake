# Builds the web page of beadswim-view: copies the folder SOURCE to FOLDER, builds the page there with the programs NODE and NPM,
# writes the page as the C++ file OUTPUT, and creates the file STAMP. If the page cannot be built, OUTPUT contains the reason
# instead, which beadswim-view prints when it is started. STAMP is then not created, so that the next build tries again.
file(REMOVE ${STAMP})
# Writes OUTPUT without a page, and warns with the reason.
function(write_missing_page reason)
  message(WARNING "beadswim-view will have no page: ${reason}")
  string(REPLACE "\\" "\\\\" reason "${reason}")
  string(REPLACE "\"" "\\\"" reason "${reason}")
  file(WRITE ${OUTPUT} "#include \"page.hpp\"\n\nconst beadswim::Page beadswim::page{nullptr, nullptr, \"${reason}\"};\n")
endfunction()

if(NOT NODE OR NOT NPM)
  write_missing_page("Beadswim was built without Node.js, which makes the page; install nodejs (18 or later) and npm, run cmake --fresh and build again")
  return()
endif()

file(MAKE_DIRECTORY ${FOLDER})
file(COPY ${SOURCE}/ DESTINATION ${FOLDER} PATTERN node_modules EXCLUDE)
set(installed ${FOLDER}/node_modules/.package-lock.json)
if(NOT EXISTS ${installed} OR ${FOLDER}/package-lock.json IS_NEWER_THAN ${installed})
  execute_process(COMMAND ${NPM} ci --include=dev --ignore-scripts --no-audit --no-fund --prefer-offline
                          --fetch-retries=1 --loglevel=error WORKING_DIRECTORY ${FOLDER}
                  RESULT_VARIABLE failed ERROR_VARIABLE errors OUTPUT_QUIET TIMEOUT 180)
  if(failed)
    message("${errors}")
    write_missing_page("when Beadswim was built, npm could not install what the page is made with (${failed}); see that npm reaches its registry, and build again")
    return()
  endif()
  file(TOUCH ${installed})
endif()
execute_process(COMMAND ${NODE} build.mjs ${OUTPUT} WORKING_DIRECTORY ${FOLDER} RESULT_VARIABLE failed)
if(failed)
  file(REMOVE ${installed})
  write_missing_page("when Beadswim was built, Node.js could not make the page (${failed}); it must be version 18 or later; see the build's messages, and build again")
  return()
endif()
file(TOUCH ${STAMP})
