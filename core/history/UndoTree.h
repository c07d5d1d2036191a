// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/history/MomentId.h"
#include "core/history/RemovedTally.h"
#include "core/history/TiledHeights.h"

namespace core::history {

/// One moment of a tooth that can be gone back to.
struct ToothMoment
{
    TiledHeights top;
    std::uint64_t tick = 0;  ///< of the attempt, after which the tooth stood like this; 0 is the uncut tooth
    double seconds = 0.0;    ///< into the attempt, when the moment came about
    Removed removed{};       ///< off the tooth at this moment
};

/// What a list of moments shows of one. The place for whatever is said about a moment.
struct MomentInfo
{
    MomentId id{};
    MomentId parent{};  ///< MomentId{}: the first that is still known
    std::uint64_t tick = 0;
    double seconds = 0.0;
    bool isCurrent = false;  ///< the newest that the tooth has been at: it may have been cut further since
    Removed removed{};
    bool operator==(const MomentInfo&) const = default;
};

/// Of a tree's moments (UndoTree::list), the last on the way to the present one at which fewer ticks were over; nothing
/// where there is none. A moment of another branch is never meant, be it ever so recent.
[[nodiscard]] std::optional<MomentId> lastBefore(std::span<const MomentInfo> moments, std::uint64_t tick);

/// The moments between strokes and a place among them. Every moment but the first follows from another; a stroke after
/// an undo begins a branch, and what was undone stays beside it.
///
/// When the moments hold more memory than the limit, they are forgotten one by one in this order: the oldest moment
/// that nothing follows from and that lies neither before the present one nor among what redo leads to; when there is
/// none such, the first moment; then the last that redo leads to. One step back and one forward are always kept.
///
/// Memory is counted as that of the tiles, each once however many moments share it, and of the moments' lists of tiles.
/// Any one thread at a time.
class UndoTree
{
public:
    static constexpr std::size_t kDefaultLimitBytes = std::size_t{64} * 1024 * 1024;

    explicit UndoTree(std::size_t limitBytes = kDefaultLimitBytes) : m_limitBytes(limitBytes) {}
    UndoTree(UndoTree&&) = default;
    UndoTree& operator=(UndoTree&&) = default;
    UndoTree(const UndoTree&) = delete;  // its moments point to each other
    UndoTree& operator=(const UndoTree&) = delete;
    ~UndoTree() = default;

    /// Forgets everything and begins with this moment.
    void restart(ToothMoment first);
    /// What the tooth has become from the present moment: a new one, and the present one from now on.
    void push(ToothMoment moment);

    /// Moments before the present one.
    [[nodiscard]] int undoSteps() const { return m_undoSteps; }
    /// Moments that redo leads to.
    [[nodiscard]] int redoSteps() const { return m_redoSteps; }
    /// Where we are. There is always one after restart().
    [[nodiscard]] const ToothMoment& current() const { return m_at->moment; }
    [[nodiscard]] MomentId currentId() const { return m_at->id; }
    /// To the moment before this one; false if there is none.
    bool undo();
    /// To that moment after this one which was visited last; false if there is none.
    bool redo();
    /// To any moment; false if it is not known, or the present one.
    bool goTo(MomentId id);

    /// Null if it is not known. Valid until the tree changes.
    [[nodiscard]] const ToothMoment* find(MomentId id) const;
    /// All moments, oldest first.
    [[nodiscard]] std::vector<MomentInfo> list() const;
    [[nodiscard]] std::size_t bytes() const { return m_bytes; }

private:
    struct Node
    {
        MomentId id{};
        ToothMoment moment;
        Node* parent = nullptr;
        std::vector<Node*> children;  ///< oldest first
        Node* visited = nullptr;      ///< the child visited last
        bool isOnTheWay = false;      ///< from the first moment to the present one and on to the last of redo
    };

    Node& add(ToothMoment moment, Node* parent);
    void remove(Node& node);
    void arriveAt(Node& node);
    void keepToLimit();
    bool forgetOne();

    std::size_t m_limitBytes;
    std::uint64_t m_lastId = 0;
    std::map<MomentId, Node> m_nodes;  ///< by id, so oldest first
    Node* m_first = nullptr;
    Node* m_at = nullptr;
    int m_undoSteps = 0;
    int m_redoSteps = 0;
    std::unordered_map<const Tile*, int> m_uses;  ///< how many moments hold a tile
    std::size_t m_bytes = 0;
};

}  // namespace core::history
