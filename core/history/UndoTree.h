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

/// A moment of a tooth that the user can return to.
struct ToothMoment
{
    TiledHeights top;
    std::uint64_t tick = 0;  ///< tick of the attempt after which the tooth was in this state; 0: the uncut tooth
    double seconds = 0.0;    ///< time of the moment in the attempt
    Removed removed{};       ///< material removed up to this moment
};

/// The entry of a moment in a list.
struct MomentInfo
{
    MomentId id{};
    MomentId parent{};  ///< MomentId{}: the first moment that is still stored
    std::uint64_t tick = 0;
    double seconds = 0.0;
    bool isCurrent = false;  ///< the last moment that the tooth was at; it may have been cut further since
    Removed removed{};
    bool operator==(const MomentInfo&) const = default;
};

/// Returns the last moment before a tick on the path to the current moment (of UndoTree::list()); empty if there is
/// none. Moments of other branches are ignored, however recent.
[[nodiscard]] std::optional<MomentId> lastBefore(std::span<const MomentInfo> moments, std::uint64_t tick);

/// The undo history of a tooth: its moments between strokes, and the current one. Every moment but the first has a
/// parent. A stroke after an undo begins a branch, and the undone moments stay.
///
/// When the moments use more memory than the limit, they are removed one by one in this order: the oldest moment
/// without children that is neither before the current one nor reachable by redo; if there is none, the first moment;
/// then the last one that redo reaches. One undo step and one redo step always stay.
///
/// Memory is counted as that of the tiles, each once however many moments share it, and of the moments' lists of tiles.
/// One thread at a time.
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

    /// Clears the history and begins with this moment.
    void restart(ToothMoment first);
    /// Adds a child of the current moment and makes it the current one.
    void push(ToothMoment moment);

    /// Returns the number of moments before the current one.
    [[nodiscard]] int undoSteps() const { return m_undoSteps; }
    /// Returns the number of moments that redo can reach.
    [[nodiscard]] int redoSteps() const { return m_redoSteps; }
    /// Returns the current moment. Call restart() first.
    [[nodiscard]] const ToothMoment& current() const { return m_at->moment; }
    [[nodiscard]] MomentId currentId() const { return m_at->id; }
    /// Goes to the parent of the current moment. Returns false if there is none.
    bool undo();
    /// Goes to the child of the current moment that was visited last. Returns false if there is none.
    bool redo();
    /// Goes to any moment. Returns false if it is unknown or the current one.
    bool goTo(MomentId id);

    /// Returns a moment; null if it is unknown. Valid until the tree changes.
    [[nodiscard]] const ToothMoment* find(MomentId id) const;
    /// Returns all moments, oldest first.
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
        bool isOnTheWay = false;      ///< on the path from the first moment to the current one and on to the last of
                                      ///< redo
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
    std::unordered_map<const Tile*, int> m_uses;  ///< number of moments that use a tile
    std::size_t m_bytes = 0;
};

}  // namespace core::history
