# How every target of the project is made: one call per library, one per test program.

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")

find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

function(toss_compile_options target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion -Wshadow
    $<$<BOOL:${TOSS_WARNINGS_AS_ERRORS}>:-Werror>)
  # Lets loops with square roots and choices be vectorised; changes no result.
  target_compile_options(${target} PRIVATE -fno-math-errno -fno-trapping-math)
  # The same bytes on every machine: no contraction of a*b+c into a fused instruction.
  target_compile_options(${target} PRIVATE -ffp-contract=off)
endfunction()

# toss_library(<name> [SHARED] [PUBLIC <dependency>...] [PRIVATE <dependency>...])
# Builds libs/<name>/src/**.cpp into toss::<name> with the headers of libs/<name>/include.
function(toss_library name)
  cmake_parse_arguments(ARG "SHARED" "" "PUBLIC;PRIVATE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS src/*.cpp)
  if(ARG_SHARED)
    set(type SHARED)
  endif()
  add_library(toss_${name} ${type} ${sources})
  add_library(toss::${name} ALIAS toss_${name})
  set_target_properties(toss_${name} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(toss_${name} PUBLIC cxx_std_17)
  target_include_directories(toss_${name} PUBLIC
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(toss_${name} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
  toss_compile_options(toss_${name})
  if(NOT ARG_SHARED)
    # Lets functions be inlined that a shared library could replace; no one replaces these.
    target_compile_options(toss_${name} PRIVATE -fno-semantic-interposition)
  endif()
  install(TARGETS toss_${name} EXPORT toss-targets)
  install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endfunction()

# toss_tests(<name> [<dependency>...]): builds ./*_test.cpp into <name>_tests, one ctest entry each.
function(toss_tests name)
  file(GLOB sources CONFIGURE_DEPENDS *_test.cpp)
  if(NOT sources)
    return()
  endif()
  add_executable(${name}_tests ${sources})
  target_include_directories(${name}_tests PRIVATE ${PROJECT_SOURCE_DIR}/tests/support)
  target_link_libraries(${name}_tests PRIVATE ${ARGN} GTest::gtest_main GTest::gmock)
  toss_compile_options(${name}_tests)
  gtest_discover_tests(${name}_tests TEST_PREFIX ${name}. DISCOVERY_MODE PRE_TEST NO_PRETTY_VALUES
    PROPERTIES TIMEOUT 600)
endfunction()

# toss_benchmark(<name> [<dependency>...]): builds ./<name>_benchmark.cpp, never run by ctest.
function(toss_benchmark name)
  add_executable(${name}_benchmark ${name}_benchmark.cpp)
  target_include_directories(${name}_benchmark PRIVATE ${PROJECT_SOURCE_DIR}/tests/support)
  target_link_libraries(${name}_benchmark PRIVATE ${ARGN} benchmark::benchmark)
  toss_compile_options(${name}_benchmark)
endfunction()
