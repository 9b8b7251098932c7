#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/error.h"

namespace timeshade {

/// Stands for everything that a cached content depends on: equal keys, equal contents, to the last bit. 0: nothing may
/// be reused.
using CacheKey = std::uint64_t;

/// One content that is kept from frame to frame for as long as its key is the same.
class CacheEntryBase {
  public:
    CacheEntryBase() = default;
    virtual ~CacheEntryBase() = default;
    CacheEntryBase(const CacheEntryBase&) = delete;
    CacheEntryBase& operator=(const CacheEntryBase&) = delete;

    /// Was this key wanted the time before, too? What changes in every frame is not worth caching: callers begin to
    /// keep a content when this is true.
    bool wantedAgain(CacheKey key) {
        used_ = true;
        return std::exchange(wanted_, key) == key && key != 0;
    }
    /// Is the content that of this key?
    bool holds(CacheKey key) {
        used_ = true;
        return key != 0 && key_ == key;
    }
    /// From now on the content is that of this key.
    void setKey(CacheKey key) { key_ = key; }

    /// Drops the content, with its memory.
    virtual void drop() { key_ = 0; }
    virtual std::size_t bytes() const = 0;

  protected:
    void markUsed() { used_ = true; }

  private:
    friend class FrameCaches;
    CacheKey key_ = 0, wanted_ = 0;
    bool used_ = false;  ///< in this frame
};

/// With the content's own type, which tells its bytes().
template <typename Content>
class CacheEntry final : public CacheEntryBase {
  public:
    /// The content, whatever its key; made of the arguments where there is none.
    template <typename... Arguments>
    Content& get(Arguments&&... arguments) {
        markUsed();
        if (!content_) content_.emplace(std::forward<Arguments>(arguments)...);
        return *content_;
    }
    const Content* find() const { return content_ ? &*content_ : nullptr; }
    void drop() override {
        CacheEntryBase::drop();
        content_.reset();
    }
    std::size_t bytes() const override { return content_ ? content_->bytes() : 0; }

  private:
    std::optional<Content> content_;
};

/// For what is kept elsewhere: the entry only says what a buffer holds.
struct NoContent {
    std::size_t bytes() const { return 0; }
};

/// All that a frame reuses from the frames before it: the one place that owns it, and one way to forget it.
class FrameCaches {
  public:
    /// The entry of that name, always of the same type. Stays where it is.
    template <typename Content>
    CacheEntry<Content>& entry(const std::string& name) {
        std::unique_ptr<CacheEntryBase>& slot = entries_[name];
        if (!slot) slot = std::make_unique<CacheEntry<Content>>();
        auto* entry = dynamic_cast<CacheEntry<Content>*>(slot.get());
        if (entry == nullptr) throw Error("cache entry '" + name + "' has two types");
        return *entry;
    }

    /// Shaders, scene or buffers are others: nothing is reused.
    void invalidateAll() {
        for (auto& [name, entry] : entries_) forget(*entry);
    }
    /// Drops what the frame that ends has not used.
    void endFrame() {
        for (auto& [name, entry] : entries_)
            if (!std::exchange(entry->used_, false)) forget(*entry);
    }
    /// Of the entries whose name begins so.
    std::size_t bytes(const std::string& beginning) const {
        std::size_t sum = 0;
        for (const auto& [name, entry] : entries_)
            if (name.rfind(beginning, 0) == 0) sum += entry->bytes();
        return sum;
    }

  private:
    static void forget(CacheEntryBase& entry) {
        entry.drop();
        entry.wanted_ = 0;
    }
    std::map<std::string, std::unique_ptr<CacheEntryBase>> entries_;
};

}  // namespace timeshade
