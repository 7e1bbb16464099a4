// Picture files that libpng, libjpeg, libtiff, giflib and libwebp write, for picture_files.cpp.
#pragma once

#include <vector>

#include "tests/support/picture_files.h"

namespace glint::test {

void addPng(std::vector<PictureFile>* files);
void addJpeg(std::vector<PictureFile>* files);
void addTiff(std::vector<PictureFile>* files);
void addGif(std::vector<PictureFile>* files);
void addWebp(std::vector<PictureFile>* files);

}  // namespace glint::test
