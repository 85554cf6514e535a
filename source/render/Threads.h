#pragma once

namespace ray {

/// How many threads can run at once, this one among them and at most `wanted`: as many as could be made just now, where
/// the system limits them. oneTBB, asked for more, would throw in the middle of its work.
int ThreadsAvailable(int wanted);

/// How many to work with where `asked` are, 0 for as many as usual. More than usual are tried by making them, so this
/// is best asked once.
int ThreadsFor(int asked);

}  // namespace ray
