# The CUDA part of a module. CMake 3.25 does not support C++20 with nvcc 13, so a custom command
# runs nvcc. Device code never spans files, so the host's linker is sufficient.
set(OBBY_CUDA_ARCHITECTURES "80;89;90" CACHE STRING "Compute capabilities to build kernels for, as in sm_80")
set(OBBY_CUDA_FLAGS "" CACHE STRING "More flags for nvcc: -Ofc=max compiles in seconds, for kernels that nobody runs")

# obby_cuda(module [folder]): *.cu of lib/<module>/<folder>, by default cuda, and its *.cpp but absent.cpp; or, without CUDA,
# absent.cpp alone.
function(obby_cuda module)
  set(folder ${CMAKE_CURRENT_SOURCE_DIR}/cuda)
  if(ARGC GREATER 1)
    set(folder ${CMAKE_CURRENT_SOURCE_DIR}/${ARGV1})
  endif()
  if(NOT OBBY_CUDA)
    target_sources(obby_${module} PRIVATE ${folder}/absent.cpp)
    return()
  endif()
  file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/absent.cpp$")
  target_sources(obby_${module} PRIVATE ${sources})
  file(GLOB kernels CONFIGURE_DEPENDS ${folder}/*.cu)
  list(TRANSFORM OBBY_CUDA_ARCHITECTURES REPLACE "(.+)" "-gencode=arch=compute_\\1,code=sm_\\1" OUTPUT_VARIABLE targets)
  # PTX for future GPUs. --fmad=false applies to it, too.
  list(GET OBBY_CUDA_ARCHITECTURES -1 last)
  list(APPEND targets -gencode=arch=compute_${last},code=compute_${last})
  foreach(kernel ${kernels})
    get_filename_component(name ${kernel} NAME_WE)
    set(object ${CMAKE_CURRENT_BINARY_DIR}/cuda_${name}.o)
    # The flags of ObbyFloat.cmake, for both of nvcc's compilers.
    add_custom_command(OUTPUT ${object}
      COMMAND ${CUDAToolkit_NVCC_EXECUTABLE} -std=c++20 -O3 --fmad=false -Xcompiler=-ffp-contract=off,-fno-tree-slp-vectorize ${targets} ${OBBY_CUDA_FLAGS}
        --Werror all-warnings -I${PROJECT_SOURCE_DIR}/lib -I${RANDOM123_INCLUDE}
        -MD -MF ${object}.d -c ${kernel} -o ${object}
      DEPENDS ${kernel} DEPFILE ${object}.d COMMENT "Compiling kernels of ${module}: ${name}" VERBATIM)
    target_sources(obby_${module} PRIVATE ${object})
    set_source_files_properties(${object} PROPERTIES EXTERNAL_OBJECT TRUE GENERATED TRUE)
  endforeach()
  target_link_libraries(obby_${module} PRIVATE CUDA::cudart_static)
endfunction()
