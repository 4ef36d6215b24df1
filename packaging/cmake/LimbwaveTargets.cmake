# How every target of Limbwave is made: one function for libraries, one for tests.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

# The compiler cache makes a second build take seconds. Precompiled headers need the two sloppiness flags.
find_program(LIMBWAVE_CCACHE ccache)
if(LIMBWAVE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER
      ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
      CCACHE_NOHASHDIR=1 CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} ${LIMBWAVE_CCACHE})
endif()

# GCC's -Wnull-dereference follows paths that only assertions rule out: without them it sees ghosts.
set(null_dereference -Wnull-dereference)
if(CMAKE_CXX_FLAGS MATCHES "-DNDEBUG")
  set(null_dereference -Wno-null-dereference)
endif()
add_library(limbwave_options INTERFACE)
target_compile_options(limbwave_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual ${null_dereference} -Wcast-align
  $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>
  $<$<BOOL:${LIMBWAVE_WARNINGS_AS_ERRORS}>:-Werror>)
# Results must not depend on the instruction set that the compiler may fuse for: live equals offline, bit for bit.
target_compile_options(limbwave_options INTERFACE -ffp-contract=off)
if(LIMBWAVE_SANITIZE)
  add_compile_options(-fsanitize=${LIMBWAVE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${LIMBWAVE_SANITIZE})
  # GCC's -Wnull-dereference and -Wmaybe-uninitialized see ghosts in instrumented code.
  target_compile_options(limbwave_options INTERFACE -Wno-null-dereference -Wno-maybe-uninitialized)
endif()

# limbwave_add_library(NAME SOURCES a.cpp ... [DEPENDS other targets, seen by users too] [PRIVATE_DEPENDS ...])
# makes limbwave_NAME with the alias limbwave::NAME; headers are included as "NAME/file.h".
function(limbwave_add_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  set(has_code FALSE)
  foreach(source IN LISTS ARG_SOURCES)
    if(source MATCHES "\\.cpp$")
      set(has_code TRUE)
    endif()
  endforeach()
  get_filename_component(parent "${CMAKE_CURRENT_SOURCE_DIR}" DIRECTORY)
  if(has_code)
    add_library(limbwave_${name} STATIC ${ARG_SOURCES})
    target_include_directories(limbwave_${name} PUBLIC "${parent}")
    target_link_libraries(limbwave_${name} PUBLIC ${ARG_DEPENDS} PRIVATE limbwave_options ${ARG_PRIVATE_DEPENDS})
  else()
    add_library(limbwave_${name} INTERFACE)
    target_include_directories(limbwave_${name} INTERFACE "${parent}")
    target_link_libraries(limbwave_${name} INTERFACE ${ARG_DEPENDS})
  endif()
  add_library(limbwave::${name} ALIAS limbwave_${name})
endfunction()

# limbwave_add_test(NAME SOURCES ... DEPENDS ... [LABELS slow interop] [QT] [SERIAL] [ENVIRONMENT ...] [TIMEOUT seconds])
# makes one GoogleTest program, or with QT one Qt Test program that runs under its own Xvfb. SERIAL: no other test runs
# beside it, because it works in real time.
function(limbwave_add_test name)
  cmake_parse_arguments(ARG "QT;SERIAL" "TIMEOUT" "SOURCES;DEPENDS;LABELS;ENVIRONMENT" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE limbwave_options ${ARG_DEPENDS})
  target_include_directories(${name} PRIVATE "${CMAKE_SOURCE_DIR}/tests")
  if(DEFINED ENV{LIMBWAVE_DATA})
    set(data "LIMBWAVE_DATA=$ENV{LIMBWAVE_DATA}")
  else()
    set(data "LIMBWAVE_DATA=${CMAKE_SOURCE_DIR}/../shared/data")
  endif()
  if(CMAKE_CURRENT_SOURCE_DIR MATCHES "/tests/ui")
    # Only here, for screenshots: a path on the command line keeps the compiler cache from serving another checkout.
    target_compile_definitions(${name} PRIVATE LIMBWAVE_SOURCE_DIR="${CMAKE_SOURCE_DIR}"
      LIMBWAVE_BINARY_DIR="${CMAKE_BINARY_DIR}")
  endif()
  if(ARG_QT)
    target_link_libraries(${name} PRIVATE Qt6::Test)
    set_target_properties(${name} PROPERTIES AUTOMOC ON)
    add_test(NAME ${name} COMMAND "${CMAKE_SOURCE_DIR}/tests/support/with_display.sh" $<TARGET_FILE:${name}>)
    set_tests_properties(${name} PROPERTIES ENVIRONMENT "${data};${ARG_ENVIRONMENT}" TIMEOUT ${ARG_TIMEOUT}
      LABELS "${ARG_LABELS}" RUN_SERIAL ${ARG_SERIAL})
  else()
    target_link_libraries(${name} PRIVATE GTest::gmock GTest::gtest GTest::gtest_main)
    # gtest_discover_tests flattens lists and drops empty values, so that every property here is one non-empty word.
    set(properties ENVIRONMENT "${data}" TIMEOUT ${ARG_TIMEOUT} RUN_SERIAL ${ARG_SERIAL})
    list(LENGTH ARG_ENVIRONMENT variables)
    list(LENGTH ARG_LABELS labels)
    if(variables GREATER 1 OR labels GREATER 1)
      message(FATAL_ERROR "${name}: a GoogleTest program takes one variable and one label at most")
    endif()
    if(ARG_ENVIRONMENT)
      string(REGEX REPLACE "^([^=]+)=" "\\1=set:" modification "${ARG_ENVIRONMENT}")
      list(APPEND properties ENVIRONMENT_MODIFICATION "${modification}")
    endif()
    if(ARG_LABELS)
      list(APPEND properties LABELS ${ARG_LABELS})
    endif()
    gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60 PROPERTIES ${properties})
  endif()
endfunction()
