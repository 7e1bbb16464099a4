#include "viewer/model/asset_reader.h"

#include <memory>
#include <vector>

#include "engine/io/used_assets.h"
#include "engine/scene/scene_use.h"

namespace glint {

void AssetReader::read() {
    if (reading_) { return; }
    reading_ = true;
    error_.reset();
    jobs_->start(
        [this, adoption = document_->adoptions(),
         asked = std::make_shared<const SceneDescription>(document_->draft())]() -> JobQueue::Completion {
            auto read = std::make_shared<CompletedScene>(completeScene(*asked));
            return [this, adoption, asked, read] {
                if (adoption == document_->adoptions()) { take(*asked, *read); }
            };
        },
        false);
}

void AssetReader::forget() {
    reading_ = false;
    arrived_ = false;
    error_.reset();
}

void AssetReader::take(const SceneDescription& asked, const CompletedScene& read) {
    reading_ = false;
    arrived_ = true;
    SceneDescription& draft = document_->draft();
    if (!read.error) {
        takeAssets(read.scene, &draft);
        return;
    }
    error_ = read.error;
    notice_->tell(*read.error, "");
    SceneDescription tried = draft;
    takeAssets(read.scene, &tried);
    const SceneDescription kept = withoutLacking(tried, *document_->posted());
    draft.environment = kept.environment;
    hideUnread(tried.meshes, &draft);
    for (size_t i = 0; i < draft.materials.size(); ++i) {
        const std::vector<int> before = inputTextures(asked.materials[i]);
        const std::vector<int> keptTextures = inputTextures(kept.materials[i]);
        const std::vector<int*> textures = inputTextures(&draft.materials[i]);
        for (size_t input = 0; input < textures.size(); ++input) {
            const bool wasAsked = *textures[input] == before[input];  // not a choice made since
            *textures[input] = wasAsked ? keptTextures[input] : *textures[input];
        }
    }
}

}  // namespace glint
