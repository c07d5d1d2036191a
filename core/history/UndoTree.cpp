// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/UndoTree.h"

#include <algorithm>
#include <cassert>

namespace core::history {
namespace {

std::size_t listBytes(const TiledHeights& top)
{
    return top.tiles().size_bytes();
}

}  // namespace

UndoTree::Node& UndoTree::add(ToothMoment moment, Node* parent)
{
    const MomentId id{++m_lastId};
    Node& node = m_nodes[id];
    node.id = id;
    node.moment = std::move(moment);
    node.parent = parent;
    if (parent != nullptr)
        parent->children.push_back(&node);
    m_bytes += listBytes(node.moment.top);
    for (const std::shared_ptr<const Tile>& tile : node.moment.top.tiles())
        if (++m_uses[tile.get()] == 1)
            m_bytes += sizeof(Tile);
    return node;
}

/// Removes a moment that has no successors, or the first moment if it has only one.
void UndoTree::remove(Node& node)
{
    assert(&node != m_at);
    assert(node.parent != nullptr ? node.children.empty() : node.children.size() == 1);
    m_bytes -= listBytes(node.moment.top);
    for (const std::shared_ptr<const Tile>& tile : node.moment.top.tiles()) {
        if (const auto uses = m_uses.find(tile.get()); --uses->second == 0) {
            m_uses.erase(uses);
            m_bytes -= sizeof(Tile);
        }
    }
    if (node.parent != nullptr) {
        std::erase(node.parent->children, &node);
        if (node.parent->visited == &node)
            node.parent->visited = node.parent->children.empty() ? nullptr : node.parent->children.back();
    } else {
        m_first = node.children.front();
        m_first->parent = nullptr;
    }
    m_nodes.erase(node.id);
}

void UndoTree::arriveAt(Node& node)
{
    for (auto& [id, other] : m_nodes)
        other.isOnTheWay = false;
    m_at = &node;
    m_at->isOnTheWay = true;
    m_undoSteps = 0;
    for (Node* after = m_at; after->parent != nullptr; after = after->parent) {
        after->parent->visited = after;
        after->parent->isOnTheWay = true;
        ++m_undoSteps;
    }
    m_redoSteps = 0;
    for (Node* next = m_at->visited; next != nullptr; next = next->visited) {
        next->isOnTheWay = true;
        ++m_redoSteps;
    }
}

void UndoTree::restart(ToothMoment first)
{
    m_nodes.clear();
    m_uses.clear();
    m_bytes = 0;
    m_first = &add(std::move(first), nullptr);
    arriveAt(*m_first);
}

void UndoTree::push(ToothMoment moment)
{
    assert(m_at != nullptr);
    arriveAt(add(std::move(moment), m_at));
    keepToLimit();
}

bool UndoTree::undo()
{
    assert(m_at != nullptr);
    if (m_at->parent == nullptr)
        return false;
    arriveAt(*m_at->parent);
    return true;
}

bool UndoTree::redo()
{
    assert(m_at != nullptr);
    if (m_at->visited == nullptr)
        return false;
    arriveAt(*m_at->visited);
    return true;
}

bool UndoTree::goTo(MomentId id)
{
    const auto found = m_nodes.find(id);
    if (found == m_nodes.end() || &found->second == m_at)
        return false;
    arriveAt(found->second);
    return true;
}

const ToothMoment* UndoTree::find(MomentId id) const
{
    const auto found = m_nodes.find(id);
    return found == m_nodes.end() ? nullptr : &found->second.moment;
}

std::vector<MomentInfo> UndoTree::list() const
{
    std::vector<MomentInfo> all;
    all.reserve(m_nodes.size());
    for (const auto& [id, node] : m_nodes)
        all.push_back({id, node.parent != nullptr ? node.parent->id : MomentId{}, node.moment.tick, node.moment.seconds,
                       &node == m_at, node.moment.removed});
    return all;
}

void UndoTree::keepToLimit()
{
    while (m_bytes > m_limitBytes && forgetOne()) {
    }
}

bool UndoTree::forgetOne()
{
    const auto beside = std::find_if(m_nodes.begin(), m_nodes.end(), [](const auto& entry) {
        return entry.second.children.empty() && !entry.second.isOnTheWay;
    });
    if (beside != m_nodes.end()) {
        remove(beside->second);
        return true;
    }
    // The remaining moments are one line.
    if (m_undoSteps > 1) {
        remove(*m_first);
        --m_undoSteps;
        return true;
    }
    if (m_redoSteps > 1) {
        Node* last = m_at;
        while (last->visited != nullptr)
            last = last->visited;
        remove(*last);
        --m_redoSteps;
        return true;
    }
    return false;
}

std::optional<MomentId> lastBefore(std::span<const MomentInfo> moments, std::uint64_t tick)
{
    auto at = std::find_if(moments.begin(), moments.end(), [](const MomentInfo& moment) { return moment.isCurrent; });
    while (at != moments.end() && at->tick >= tick)
        at = std::find_if(moments.begin(), moments.end(),
                          [parent = at->parent](const MomentInfo& moment) { return moment.id == parent; });
    return at == moments.end() ? std::nullopt : std::optional(at->id);
}

}  // namespace core::history
