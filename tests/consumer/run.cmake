# Installs the build in BUILD, builds SOURCE against what was installed, and runs it on SCENE.
set(work ${BUILD}/tests/consumer)
file(REMOVE_RECURSE ${work})

function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGV}: ${result}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${work}/installed)
run(${CMAKE_COMMAND} -S ${SOURCE} -B ${work}/build -G ${GENERATOR} -D CMAKE_MAKE_PROGRAM=${MAKE} -D CMAKE_CXX_COMPILER=${COMPILER}
  -D CMAKE_BUILD_TYPE=Release -D CMAKE_PREFIX_PATH=${work}/installed)
run(${CMAKE_COMMAND} --build ${work}/build)
run(${work}/build/consumer ${SCENE})
message("${output}")
# A room with a lamp: all its light arrives, and more than once.
if(NOT output MATCHES "^hits 200[0-9][0-9][0-9], arriving [1-9][0-9.e+]* W, mean irradiance [0-9.e+]+ W/m\\^2, map [1-9][0-9]+ bytes")
  message(FATAL_ERROR "the consumer says: ${output}")
endif()
