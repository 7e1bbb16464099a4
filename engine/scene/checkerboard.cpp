#include "engine/scene/checkerboard.h"

#include "engine/scene/image.h"

namespace glint {

std::shared_ptr<const ImageF> generateCheckerboard(const Checkerboard& board) {
    auto image = std::make_shared<ImageF>(ImageF{2, 2, {}});
    for (const Vec3& square : {board.odd, board.even, board.even, board.odd}) {  // the top row first
        image->rgb.insert(image->rgb.end(), {square.x, square.y, square.z});
    }
    return image;
}

}  // namespace glint
