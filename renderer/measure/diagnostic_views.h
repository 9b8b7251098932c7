#pragma once

#include <vector>

#include "image/image_file.h"
#include "measure/verification.h"

namespace timeshade {

/// |image - reference|, the largest of the three channels in linear light, in a colour map whose lightness grows evenly
/// (OKLab), over four decades up to `fullScale`; a scale stands below. Each pixel becomes a square of `enlarged` pixels
/// a side; the scale's letters keep their size. Throws Error where the sizes differ.
DisplayImage errorView(const LinearImage& image, const LinearImage& reference, double fullScale = 1.0,
                       int enlarged = 1);

/// Counts per pixel the camera samples whose lit value is wrong.
class DisagreementView {
  public:
    DisagreementView(int width, int height);
    /// To be handed to verifyFrame.
    void add(const VerifiedSample& sample);
    /// The picture in grey, false shadow in blue, false lit in orange, each as strong as its share of the pixel's
    /// tested samples; a legend with both counts stands below. `picture` has the view's size; `enlarged` as above.
    DisplayImage draw(const DisplayImage& picture, int enlarged = 1) const;

  private:
    struct Counts {
        unsigned tested = 0, falseShadow = 0, falseLit = 0;
    };
    int width_, height_;
    std::vector<Counts> pixels_;  ///< rows from the top
};

}  // namespace timeshade
