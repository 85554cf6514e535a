#!/bin/sh
# Asks for memory without end.
exec tail /dev/zero
