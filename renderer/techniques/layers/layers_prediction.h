#pragma once

#include <map>
#include <memory>
#include <utility>

#include "technique/prediction.h"
#include "techniques/layers/layer_grids.h"

namespace timeshade {

/// What filtered layers must compute, from the paper's text (Andersson et al. 2015, sections 4 and 5) and the repairs
/// that LayersShadow states: the same steps in double precision, on samples that stand for the mean over the random
/// times of a stratum. Where a tile is chosen by chance the mean over the choices.
class LayersPrediction final : public Prediction {
  public:
    struct Options {
        LayerGrids::Options grids;
        bool equation9Alone, neighbourTiles;
        int strata;  ///< of the map; 0: as many as camera samples
        double biasTexels;
    };
    explicit LayersPrediction(const Options& options) : options_(options) {}

    std::optional<double> lit(const ReceiverInMap& receiver, double u) const override;

  private:
    struct Tile;
    const Tile& tileAt(const ReceiverInMap& receiver, const glm::ivec2& tile) const;
    double litInTile(const ReceiverInMap& receiver, double u, const glm::ivec2& tile) const;
    bool inStaticShadow(const ReceiverInMap& receiver, double u) const;

    Options options_;
    /// Tiles of the scene asked about last, by which triangles they were made of.
    mutable const void* scene_ = nullptr;
    mutable std::map<std::pair<int, int>, std::shared_ptr<const Tile>> tiles_;
};

}  // namespace timeshade
