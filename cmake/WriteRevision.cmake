cmake_minimum_required(VERSION 3.25)
# Writes the header file OUTPUT with the git revision of the folder SOURCE. Does not touch the file if the revision has not
# changed.
execute_process(COMMAND git -C ${SOURCE} describe --always --dirty --abbrev=10 --exclude=*
                OUTPUT_VARIABLE revision OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT revision)
  set(revision "unknown")
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "#define BEADSWIM_REVISION \"@revision@\"\n" @ONLY)
