# Every library that Limbwave builds on; their Debian packages are in packaging/dependencies.txt.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(ZLIB REQUIRED)
find_package(TinyGLTF REQUIRED)
find_package(assimp 5.2 REQUIRED)
pkg_check_modules(SNDFILE REQUIRED IMPORTED_TARGET sndfile)
pkg_check_modules(SERIALPORT REQUIRED IMPORTED_TARGET libserialport)
pkg_check_modules(PORTAUDIO REQUIRED IMPORTED_TARGET portaudio-2.0)
# Only to ask devices what they offer and to keep the two libraries from writing to the terminal.
pkg_check_modules(ALSA REQUIRED IMPORTED_TARGET alsa)
pkg_check_modules(JACK REQUIRED IMPORTED_TARGET jack)

# Third-party headers are system headers: their warnings are not ours.
foreach(target Eigen3::Eigen nlohmann_json::nlohmann_json CLI11::CLI11 assimp::assimp)
  get_target_property(includes ${target} INTERFACE_INCLUDE_DIRECTORIES)
  if(includes)
    set_target_properties(${target} PROPERTIES INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${includes}")
  endif()
endforeach()

# Debian's target names what the shared library itself needs. One of it, libdraco, has a tinygltf of its own inside:
# a program that links it would call that one instead of libtinygltf, with other layouts of the same classes.
set_target_properties(assimp::assimp PROPERTIES INTERFACE_LINK_LIBRARIES "")

if(LIMBWAVE_BUILD_STUDIO)
  find_package(Qt6 6.4 REQUIRED COMPONENTS Core Gui Widgets Svg 3DCore 3DRender 3DInput 3DExtras LinguistTools Test)
endif()

if(LIMBWAVE_BUILD_TESTS)
  find_package(GTest REQUIRED)
  find_package(benchmark REQUIRED)
  include(GoogleTest)
endif()
