#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <utility>

namespace timeshade {

/// States in the order in which they were, and where among them one is. The oldest are dropped beyond `most` steps.
template <typename State>
class UndoHistory {
  public:
    static constexpr std::size_t most = 1000;

    /// What is now. Other than before, it is a step: what had been undone is gone.
    void keep(const State& now) {
        if (current_ && *current_ == now) return;
        if (current_) past_.push_back(std::move(*current_));
        if (past_.size() > most) past_.pop_front();
        current_ = now;
        future_.clear();
    }
    /// The state before, which is now the current one; nothing where there is none.
    std::optional<State> undo() { return go(past_, future_); }
    std::optional<State> redo() { return go(future_, past_); }
    /// The current state can't be had any more: `instead` takes its place.
    void replaceCurrent(const State& instead) { current_ = instead; }

    std::size_t undoable() const { return past_.size(); }
    std::size_t redoable() const { return future_.size(); }
    /// What is kept, for states that have a size in bytes.
    std::size_t bytes() const {
        std::size_t bytes = current_ ? current_->size() : 0;
        for (const std::deque<State>* states : {&past_, &future_})
            for (const State& state : *states) bytes += sizeof(State) + state.size();
        return bytes;
    }

  private:
    std::optional<State> go(std::deque<State>& from, std::deque<State>& to) {
        if (from.empty()) return std::nullopt;
        to.push_back(std::move(*current_));
        current_ = std::move(from.back());
        from.pop_back();
        return current_;
    }

    std::deque<State> past_, future_;  ///< the nearest last
    std::optional<State> current_;
};

}  // namespace timeshade
