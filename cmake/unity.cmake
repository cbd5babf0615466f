# Sources of a room compiled together, some at a time: each alone reads the same headers again, so that all of them are
# sooner done this way. Names of an unnamed namespace meet there. A file whose names are those of a neighbour is told by the compiler
# ("redefinition of"), and goes on the list.
set(MIEN_TOGETHER 12)
set(MIEN_ALONE command_line/help config/formula config/load_clip_laws config/load_clip_scripts config/load_fold_data
               config/load_idle core/simplify head/beard head/eyes head/hair_chart head/hair_locks
               head/hair_mass head/hair_relief head/hair_strand head/lip_veil head/scan_ear head/skin_spots head/teeth head/wrap_finish import/read_ply live/coarse
               print/opening print/report print/thicken print/thickness scene/openscad_check scene/openscad_numbers
               scene/povray_stage scene/strip scene/tiny_gltf scene/wavefront timeline/exposure)

# Eigen's solvers take longer to read and to make than all else: those who solve with them share one.
set(MIEN_SOLVERS frames/ink_tone head/cloud head/eye_fit head/fields head/half_system head/least_squares head/skin_atlas head/solve)

# mien_compile_together(SOURCE...): sets the group that each is of.
function(mien_compile_together)
  foreach(source IN LISTS ARGN)
    file(RELATIVE_PATH name "${CMAKE_CURRENT_SOURCE_DIR}/src" "${source}")
    string(REGEX REPLACE "[.]cpp$" "" name "${name}")
    get_filename_component(room "${name}" DIRECTORY)
    if(name IN_LIST MIEN_ALONE)
      continue()
    endif()
    if(name IN_LIST MIEN_SOLVERS)
      set_source_files_properties("${source}" PROPERTIES UNITY_GROUP solvers)
      continue()
    endif()
    list(APPEND of_${room} "${source}")
    list(LENGTH of_${room} count)
    math(EXPR group "(${count} - 1) / ${MIEN_TOGETHER}")
    set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${room}_${group}")
  endforeach()
endfunction()
