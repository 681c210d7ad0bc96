# af2_shipped_rules(FOLDER GENERATED): the texts of the rule files below FOLDER become GENERATED/shipped_rules.inc, which
# lists them as {"NAME", R"(content)"}. A change of a file makes the list again.
function(af2_shipped_rules folder generated)
  file(GLOB_RECURSE rule_files CONFIGURE_DEPENDS "${folder}/*.af2")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${rule_files})
  set(shipped_rules "")
  foreach(rule_file IN LISTS rule_files)
    file(READ "${rule_file}" text)
    file(RELATIVE_PATH name "${folder}" "${rule_file}")
    string(APPEND shipped_rules "{\"${name}\", R\"af2rules(${text})af2rules\"},\n")
  endforeach()
  file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/shipped_rules.txt" "${shipped_rules}")
  configure_file("${CMAKE_CURRENT_BINARY_DIR}/shipped_rules.txt" "${generated}/shipped_rules.inc" COPYONLY)
endfunction()
