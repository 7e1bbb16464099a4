# What `cmake --install` copies: the programs, scenes with their schema, and what a user reads. Shaders are in the
# program, fonts are the distribution's, and scenes name their files relative to themselves, so nothing has to be found.

include(GNUInstallDirs)

install(TARGETS glint glint_measure RUNTIME)
install(DIRECTORY scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/glint FILES_MATCHING PATTERN *.json PATTERN *.txt PATTERN *.obj PATTERN *.png PATTERN *.hdr)

# Thumbnails lie beside the scenes, as in the sources: an empty window shows them.
install(DIRECTORY assets/scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/glint/assets)

# Pages keep their places among each other, so that links between them hold.
foreach(page IN ITEMS README.md CHANGELOG.md scenes/README.md viewer/commands/README.md viewer/window/README.md)
    get_filename_component(folder ${page} DIRECTORY)
    install(FILES ${page} DESTINATION ${CMAKE_INSTALL_DOCDIR}/${folder})
endforeach()
install(DIRECTORY assets DESTINATION ${CMAKE_INSTALL_DOCDIR})
