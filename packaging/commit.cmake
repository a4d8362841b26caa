# Names the commit of a folder of sources, for provenance: "262a408bc461", or "262a408bc461-changed" if tracked files
# differ from it; and its day, for the manual pages. An archive of `git archive` carries both here, and has them even
# within a clone of something else. A folder without either has no commit, and the day is today.
set(COMMIT_OF_ARCHIVE "$Format:%H$")
set(DAY_OF_ARCHIVE "$Format:%cs$")
find_package(Git QUIET)

# Sets the variable to what git prints of the folder; to "" without git or outside a clone.
function(ask_git folder variable)
  set(said "")
  if(Git_FOUND)
    execute_process(COMMAND ${GIT_EXECUTABLE} --no-optional-locks -C ${folder} ${ARGN}
                    OUTPUT_VARIABLE said OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  endif()
  set(${variable} "${said}" PARENT_SCOPE)
endfunction()

function(name_commit folder variable)
  if(COMMIT_OF_ARCHIVE MATCHES "^[0-9a-f]+$")
    string(SUBSTRING ${COMMIT_OF_ARCHIVE} 0 12 commit)
  else()
    ask_git(${folder} commit rev-parse --short=12 HEAD)
    ask_git(${folder} changes status --porcelain --untracked-files=no)
    if(commit AND changes)
      string(APPEND commit "-changed")
    endif()
  endif()
  set(${variable} "${commit}" PARENT_SCOPE)
endfunction()

function(name_day folder variable)
  if(DAY_OF_ARCHIVE MATCHES "^[0-9-]+$")
    set(day ${DAY_OF_ARCHIVE})
  else()
    ask_git(${folder} day show --no-patch --format=%cs HEAD)
  endif()
  if(NOT day)
    string(TIMESTAMP day "%Y-%m-%d" UTC)
  endif()
  set(${variable} "${day}" PARENT_SCOPE)
endfunction()
