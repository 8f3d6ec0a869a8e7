namespace frostfill{}
