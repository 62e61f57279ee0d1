# The fastest linker there is: the usual one takes several times as long on deal.II.
include(CheckLinkerFlag)
foreach(linker mold lld gold)
  check_linker_flag(CXX -fuse-ld=${linker} links_with_${linker})
  if(links_with_${linker})
    add_link_options(-fuse-ld=${linker})
    break()
  endif()
endforeach()
