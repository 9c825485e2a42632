# The WASM module is fetched before anything runs, so its size counts, too: what takes hardly any of a job's time is
# compiled to be small. Learning, searches, folding, flaps and packing are not. Moves from `engine_sources` into
# `small_sources` what is to be smallest, and into `loop_sources` what is to be small and still vectorised.

if(NOT EMSCRIPTEN)
  return()
endif()

set(cpp "${PROJECT_SOURCE_DIR}/cpp")
file(GLOB_RECURSE small_sources CONFIGURE_DEPENDS
  "${cpp}/mesh/*.cpp" "${cpp}/paper/*.cpp" "${cpp}/pipeline/*.cpp" "${cpp}/read/*.cpp" "${cpp}/repair/*.cpp"
  "${cpp}/segment/*.cpp" "${cpp}/simplify/*.cpp")

# Where jobs spend their time.
set(fast_in_mesh nearest_face surface_tree)
set(fast_in_paper callouts craft_cost craft_sides flap_cover flap_room flaps label_space packing raster room_profile
  silhouette text_box)
set(fast_in_segment affinity analyze_unfolding concave_geodesic foldability k_means min_cut smooth_borders)
foreach(folder mesh paper segment)
  list(TRANSFORM fast_in_${folder} REPLACE ".+" "${cpp}/${folder}/\\0.cpp")
  foreach(source IN LISTS fast_in_${folder})
    if(NOT EXISTS "${source}")
      message(FATAL_ERROR "${source} is to be fast, but is not there")
    endif()
  endforeach()
  list(REMOVE_ITEM small_sources ${fast_in_${folder}})
endforeach()

list(REMOVE_ITEM engine_sources ${small_sources})

# Loops over all of a file, or a matrix: a model of a million triangles is read in seconds.
set(loop_sources ${small_sources})
list(FILTER loop_sources INCLUDE REGEX "/cpp/(read|repair|simplify)/|/spectral")
# These go through few things, or call others that loop.
list(FILTER loop_sources EXCLUDE REGEX "/(unite_bodies|make_manifold|mend_bodies|repair|thin_bodies|joints|model_files|model_format|mirror_half|simplify)\\.cpp$")
list(REMOVE_ITEM small_sources ${loop_sources})

# Elsewhere: what is done once per net, or for the few nets and faces that need it.
set(once_per_net fold/planner fold/shape_trees fold/waypoint_search geometry/box_pairs geometry/face_contact search/border_exchange
  search/genetic_search search/overlap_cut unfold/congruence unfold/net)
list(TRANSFORM once_per_net REPLACE ".+" "${cpp}/\\0.cpp")
list(APPEND loop_sources ${once_per_net})
list(REMOVE_ITEM engine_sources ${once_per_net})
