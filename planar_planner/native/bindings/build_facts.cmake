# Writes build_facts.hpp. Runs at every build, so that the commit is never an old one; the file is
# only touched when something has changed. COMMIT is looked up here unless the packager states it;
# it stays empty in an unpacked source distribution, even one inside some other repository.
if(NOT COMMIT)
  find_program(GIT git)
  if(GIT)
    execute_process(COMMAND ${GIT} rev-parse --show-toplevel WORKING_DIRECTORY ${SOURCE}
                    OUTPUT_VARIABLE top OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    file(REAL_PATH "${SOURCE}" source)
    if(top AND top STREQUAL source)
      execute_process(COMMAND ${GIT} describe --always --dirty --abbrev=12 --exclude=*
                      WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE COMMIT
                      OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    endif()
  endif()
endif()
string(STRIP "${FLAGS}" FLAGS)
string(REPLACE "\\" "\\\\" FLAGS "${FLAGS}")
string(REPLACE "\"" "\\\"" FLAGS "${FLAGS}")
configure_file(${TEMPLATE} ${HEADER} @ONLY)
