# Names the commit of a folder of sources, for provenance: "262a408bc461", or "262a408bc461-changed" if tracked files
# differ from it. An archive of `git archive` carries its commit here; it is empty for other folders without git.
set(COMMIT_OF_ARCHIVE "$Format:%H$")
find_package(Git QUIET)

function(name_commit folder variable)
  set(commit "")
  if(Git_FOUND)
    set(git ${GIT_EXECUTABLE} --no-optional-locks -C ${folder})
    execute_process(COMMAND ${git} rev-parse --short=12 HEAD
                    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    execute_process(COMMAND ${git} status --porcelain --untracked-files=no
                    OUTPUT_VARIABLE changes OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(commit AND changes)
      string(APPEND commit "-changed")
    endif()
  endif()
  if(NOT commit AND COMMIT_OF_ARCHIVE MATCHES "^[0-9a-f]+$")
    string(SUBSTRING ${COMMIT_OF_ARCHIVE} 0 12 commit)
  endif()
  set(${variable} "${commit}" PARENT_SCOPE)
endfunction()
