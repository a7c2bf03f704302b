# Writes the last commit that changed what is built, "-dirty" behind it where sources differ from it, into a header:
# cmake -D SOURCE=FOLDER -D HEADER=FILE -P commit.cmake
# The header is touched only where that changes. What lies in results/ does not make a program another one.
execute_process(
  COMMAND git -C ${SOURCE} log -1 --abbrev=12 --format=%h -- . ":(exclude)results"
  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
  set(commit unknown)
else()
  execute_process(
    COMMAND git -C ${SOURCE} diff --quiet HEAD -- . ":(exclude)results" ERROR_QUIET RESULT_VARIABLE differs)
  if(differs)
    string(APPEND commit -dirty)
  endif()
endif()
file(CONFIGURE OUTPUT ${HEADER} CONTENT [[
// Written by bench/setup/commit.cmake.
#pragma once

namespace bench {

inline constexpr const char* build_commit = "@commit@";

}  // namespace bench
]] @ONLY)
