#include "window/case_study.h"

#include <exception>
#include <optional>
#include <utility>

#include "core/pause.h"
#include "gl/errors.h"
#include "scene_catalogue.h"
#include "techniques/registry.h"
#include "window/session.h"

namespace timeshade {

const ClosedFormCase* CaseStudy::caseOf(const std::string& scene) {
    const std::optional<std::string> name = caseNameIn(scene);
    if (!name) return nullptr;
    for (const ClosedFormCase& c : closedFormCases())
        if (c.scene && c.name == *name) return &c;
    return nullptr;
}

bool CaseStudy::update(Session& session) {
    if (!std::exchange(wanted_, false) || !session.driver.settled()) return false;
    const ClosedFormCase* const shown = caseOf(session.scene.name());
    if (shown == nullptr) return false;
    const ProbeSubject now = subjectOf(session);
    const std::vector<TechniqueDescription>& all = techniqueDescriptions();
    std::vector<double> key = now.settings;
    key.insert(key.end(), {double(now.samplesPerPixel), double(now.mapSize.width), double(now.mapSize.height),
                           double(session.shaders.number)});
    for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i].name == now.technique) key.push_back(double(i));
    if (case_ != shown->name || key_ != key) {
        results_.clear();
        case_ = shown->name;
        key_ = std::move(key);
    }
    if (results_.size() == all.size()) return false;
    const std::string& name = all[results_.size()].name;
    if (!renderer_) renderer_.emplace();
    CaseResult result;
    try {
        const std::unique_ptr<Technique> technique = name == now.technique ? techniqueOf(now, renderer_->programs())
                                                                           : makeTechnique(name, renderer_->programs());
        result = runCase(*renderer_, *technique, *shown, {now.samplesPerPixel, now.mapSize});
    } catch (const WorkCancelled&) {
        throw;  // this technique begins anew
    } catch (const std::exception& error) {
        gl::takeErrors();  // not to be taken for the next picture's
        result.technique = name;
        result.reason = error.what();
    }
    results_.push_back(std::move(result));
    if (results_.size() == all.size()) renderer_.reset();
    return true;
}

}  // namespace timeshade
