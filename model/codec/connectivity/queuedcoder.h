// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/taskqueue.h"
#include "model/codec/connectivity/symbolmodel.h"
#include "model/codec/entropy/rangecoder.h"

#include <optional>
#include <variant>

namespace model::codec {

/// A range encoder that works beside the walk, in another thread: what is coded, nothing in the encoder's walk waits
/// for. Same interface, same bytes.
///
/// Probabilities are those that the walk computes, so that its models have learned when it goes on. The model of the
/// symbols, most of the work, belongs to the coder until finish(), or the end of its Hold: it learns beside the walk.
class QueuedCoder
{
public:
    QueuedCoder() { mEntries.reserve(BlockSize); }

    /// Made after the model, so that whichever way it goes, nothing uses it any more.
    class Hold
    {
    public:
        explicit Hold(QueuedCoder &coder)
            : mCoder(coder)
        {}
        ~Hold() { mCoder.mQueue.reset(); }
        Hold(const Hold &) = delete;
        Hold &operator=(const Hold &) = delete;

    private:
        QueuedCoder &mCoder;
    };

    std::uint32_t decision(std::uint32_t probabilityOfOne, std::uint32_t value)
    {
        add(Given{probabilityOfOne, value});
        return value;
    }
    std::uint32_t direct(unsigned count, std::uint32_t value)
    {
        add(Direct{count, value});
        return value;
    }
    Clers symbol(SymbolModel &model, const GateView &gate, Clers symbol)
    {
        if (!mSymbols) // once, before the other thread reads it
            mSymbols = &model;
        add(Symbol{gate, symbol});
        return symbol;
    }
    bool isBad() const { return false; }
    Bytes finish()
    {
        pass();
        mQueue->finish();
        return mCoder.finish();
    }

private:
    struct Given
    {
        std::uint32_t probabilityOfOne, value;
    };
    struct Direct
    {
        unsigned count;
        std::uint32_t value;
    };
    struct Symbol
    {
        GateView gate;
        Clers symbol;
    };
    using Entry = std::variant<Symbol, Given, Direct>;

    // Blocks that stay in the cache until they are coded, few enough of them.
    static constexpr std::size_t BlockSize = 4096;
    static constexpr std::size_t MostBlocks = 4;

    void add(const Entry &entry)
    {
        mEntries.push_back(entry);
        if (mEntries.size() == BlockSize)
            pass();
    }

    void pass()
    {
        mQueue->run([this, entries = std::move(mEntries)] {
            for (const Entry &entry : entries)
                std::visit([this](const auto &e) { code(e); }, entry);
        });
        mEntries = {};
        mEntries.reserve(BlockSize);
    }

    void code(const Symbol &e) { mSymbols->code(mCoder, e.gate, e.symbol); }
    void code(const Given &e) { mCoder.decision(e.probabilityOfOne, e.value); }
    void code(const Direct &e) { mCoder.direct(e.count, e.value); }

    RangeEncoder mCoder;
    SymbolModel *mSymbols = nullptr;
    std::vector<Entry> mEntries;
    std::optional<TaskQueue> mQueue{MostBlocks};
};

/// Codes a symbol, now or, with a QueuedCoder, later.
template <class Coder>
Clers codeSymbol(Coder &coder, SymbolModel &model, const GateView &gate, Clers wanted)
{
    return model.code(coder, gate, wanted);
}
inline Clers codeSymbol(QueuedCoder &coder, SymbolModel &model, const GateView &gate, Clers wanted)
{
    return coder.symbol(model, gate, wanted);
}

} // namespace model::codec
