#pragma once

#include <string>
#include <vector>

namespace timeshade::gl {

/// What the driver complained of through KHR_debug: errors and undefined behaviour, in order. Performance hints
/// and notices are left out.
class DebugLog {
  public:
    /// Hooks into the current context. The object must outlive it or be destroyed while it is current.
    DebugLog();
    ~DebugLog();
    DebugLog(const DebugLog&) = delete;
    DebugLog& operator=(const DebugLog&) = delete;

    const std::vector<std::string>& messages() const { return messages_; }
    void clear() { messages_.clear(); }
    void add(std::string message) { messages_.push_back(std::move(message)); }

  private:
    std::vector<std::string> messages_;
};

}  // namespace timeshade::gl
