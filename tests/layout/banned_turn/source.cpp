int nothingCarries = 0; // whoever reads this has to guess
